// One `poreclog-attempt --serve`: keeps one attempt after another for us.
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

#include "execute/executor.h"

namespace colloid {

class KeeperProcess {
 public:
  /// Starts the program.  It outlives us if it is keeping an attempt then.  StorageError
  /// if it cannot be started.
  explicit KeeperProcess(const std::string& program);
  KeeperProcess(KeeperProcess&& other) noexcept;
  KeeperProcess& operator=(KeeperProcess&& other) = delete;
  ~KeeperProcess();

  pid_t process() const { return process_; }

  /// Hands it an attempt; false if it is gone.  Not while it keeps another.
  bool begin(const Job& job);

  /// How the attempt ended (attempt/protocol.h), or kGone; none if it has not.  When it
  /// has, the caller gets a SIGCHLD.
  std::optional<int> ending();
  static constexpr int kGone = -1;  ///< the program was killed, or has ended

 private:
  pid_t process_ = 0;
  int attempts_ = -1;  ///< where they go
  int endings_ = -1;   ///< where they come from
  bool is_busy_ = false;
};

}  // namespace colloid
