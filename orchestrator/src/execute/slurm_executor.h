// Attempts as tasks of job arrays on a Slurm cluster.
#pragma once

#include <string>
#include <unordered_map>

#include "campaign/plan.h"
#include "execute/executor.h"
#include "execute/slurm_jobs.h"
#include "execute/slurm_layout.h"

namespace colloid {

class SlurmExecutor : public Executor {
 public:
  /// `keeper`: the path of poreclog-attempt, as the compute nodes see it too.
  /// `realisations`: how many there may be to run.
  SlurmExecutor(const Plan& plan, const SlurmClient& client, const SlurmJournal& journal,
                SlurmJobs& jobs, std::string keeper, long realisations);

  /// Of the next array.  What is to be tried again waits until the others have ended, and
  /// goes together: an sbatch for each would be too many.
  std::size_t free_slots() const override;
  /// One array.  InputError with sbatch's words if it is refused and is the first.
  void submit(const std::vector<Job>& jobs) override;
  bool adopt(const Job& job) override;
  std::vector<std::int64_t> poll() override;
  void cancel(Stop how) override;
  double pace() const override { return pace_; }
  bool outlasts_caller() const override { return true; }
  std::string limited_by() const override { return refusal_; }

 private:
  const Plan& plan_;
  const SlurmClient& client_;
  const SlurmJournal& journal_;
  SlurmJobs& jobs_;
  std::string keeper_;
  SlurmLayout layout_;
  std::unordered_map<std::int64_t, std::string> running_;  ///< id -> attempt's folder
  bool sending_ = true;
  bool has_sent_ = false;
  std::string refusal_;  ///< of a later array: the queue is full
  double pace_ = 1.0;    ///< [s]
};

}  // namespace colloid
