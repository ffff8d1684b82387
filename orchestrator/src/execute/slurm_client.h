// Slurm's command line tools: what they are asked and what they answer.
//
// They are started with their words, never through a shell, and given a minute.  An
// answer that does not come, or is not understood, is told apart from "there is no such
// job": only the latter means that something has ended.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace colloid {

/// What a site allows, from `scontrol show config` and `scontrol show partition`.
struct SlurmLimits {
  long array_size = 0;   ///< MaxArraySize: indices are below it
  long job_count = 0;    ///< MaxJobCount: jobs the controller keeps, of all users
  double seconds = 0.0;  ///< MaxTime of the partition [s]; 0: none
};

/// One task of an array, as squeue lists it.
struct SlurmTask {
  static constexpr int kAll = -1;
  std::int64_t job = 0;  ///< of the array
  int index = 0;         ///< kAll: of those that Slurm no longer tells apart
  std::string state;     ///< PENDING, RUNNING, COMPLETED, ...
  std::string reason;    ///< why it waits
  std::string name;      ///< of the job
};

enum class Answer { yes, no, none };

class SlurmClient {
 public:
  /// Clears variables that would change what the tools answer (SQUEUE_PARTITION, say).
  SlurmClient();

  /// InputError if Slurm is not there or does not answer.
  SlurmLimits limits(const std::string& partition) const;

  struct Submitted {
    std::optional<std::int64_t> job;  ///< none: refused, or the answer was lost
    std::string message;              ///< of sbatch
  };
  /// `words`: what follows "sbatch --parsable".
  Submitted submit(const std::vector<std::string>& words) const;

  /// All tasks of this user that Slurm still knows, ended ones too; none: no answer.
  std::optional<std::vector<SlurmTask>> tasks() const;

  /// Does Slurm know the job?
  Answer knows(std::int64_t job) const;

  /// The job of that name in the accounting, if there is accounting and it knows it:
  /// squeue forgets what has ended.
  std::optional<std::int64_t> accounted(const std::string& name) const;

  /// Stops jobs: a signal ("QUIT") for those that run, or if empty an end to all of them.
  void cancel(const std::vector<std::int64_t>& jobs, const std::string& signal) const;
};

/// Does a task in that state run, or may it yet?  None: the word is not known.
std::optional<bool> is_active_state(const std::string& state);

/// A time limit as Slurm writes it: "30", "1-12:00:00", "UNLIMITED" (0) [s].
double slurm_seconds(const std::string& text);

}  // namespace colloid
