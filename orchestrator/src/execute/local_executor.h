// A pool of solver processes on this machine.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "execute/executor.h"
#include "execute/keeper_process.h"

namespace colloid {

class LocalExecutor : public Executor {
 public:
  /// `workers` jobs at once; `keeper`: the path of poreclog-attempt.
  LocalExecutor(int workers, std::string keeper);

  std::size_t free_slots() const override;
  void submit(const std::vector<Job>& jobs) override;
  bool adopt(const Job& job) override;
  std::vector<std::int64_t> poll() override;
  void cancel(Stop how) override;
  double pace() const override;
  bool outlasts_caller() const override { return false; }

 private:
  struct Running {
    std::optional<KeeperProcess> keeper;  ///< none: an earlier process's, or killed
    std::string folder;                   ///< of the attempt
  };

  /// Has it ended?  Notes why if its keeper could not make the folder.
  bool has_ended(Running& job);

  std::size_t workers_;
  std::string keeper_;
  std::map<std::int64_t, Running> running_;
  std::vector<KeeperProcess> idle_;
  std::vector<std::int64_t> ended_;  ///< not reported yet
  std::string failure_;              ///< the first of a keeper; told once
  bool has_told_ = false;
};

/// Is an attempt running in this folder, on this machine?
bool is_running(const std::string& attempt_folder);

/// The keeper and the host that are written in an attempt's lock; 0 and "" if none are.
struct Keeper {
  pid_t process = 0;
  std::string host;
};
Keeper keeper_of(const std::string& attempt_folder);

/// This machine's name.
std::string host_name();

/// The path of poreclog-attempt beside this program.  InputError if it is not there.
std::string find_keeper();

}  // namespace colloid
