// Where attempts run: this machine, or a cluster's scheduler.  Another scheduler is
// another file with these functions.
//
// An executor starts attempts and says when they are no longer running, no more.  How
// they ended is written in their folders, by poreclog-attempt and the solver, and read
// from there: so it is known also when the executor's process did not live to see it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace colloid {

struct Job {
  std::int64_t id = 0;               ///< of the caller's choice
  std::string folder;                ///< of the attempt
  std::vector<std::string> command;  ///< of the solver
  std::string command_line;          ///< the same as a shell would take it
  double seconds = 0.0;              ///< wall-time limit, enforced within the job [s]
  double seconds_to_stop = 0.0;      ///< from a polite stop to a kill [s]
};

/// How urgently jobs are to stop.
enum class Stop {
  politely,  ///< the solver writes a checkpoint
  at_once
};

class Executor {
 public:
  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// How many more jobs are welcome now.
  virtual std::size_t free_slots() const = 0;
  /// Starts (or queues) jobs: makes the attempts' folders, in which `command` is then,
  /// and never begins one whose folder is there.  StorageError, here or by poll(), if a
  /// folder cannot be made or the executor itself does not work.
  virtual void submit(const std::vector<Job>& jobs) = 0;
  /// Takes over a job that an earlier process submitted; false if it runs no more.
  virtual bool adopt(const Job& job) = 0;
  /// Ids of the jobs that have ended since the last call.
  virtual std::vector<std::int64_t> poll() = 0;
  /// Asks all jobs to stop; they still have to be polled.
  virtual void cancel(Stop how) = 0;
  /// How long the caller may wait between two polls if no child of it ends [s].
  virtual double pace() const = 0;
  /// Do jobs go on without the caller, to be adopted by a later process?  Then nobody has
  /// to stop them because the caller stops.
  virtual bool outlasts_caller() const = 0;
  /// Why it takes no more jobs for now, in the scheduler's words; empty if it would.
  virtual std::string limited_by() const { return ""; }
};

}  // namespace colloid
