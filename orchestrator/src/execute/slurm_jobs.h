// The campaign's submissions to Slurm, and where each of their tasks is.
//
// What is finished is read from the attempts' folders; Slurm is only asked whether a task
// may still do something.  A task that Slurm does not list has ended if Slurm answered
// for its array, or says that there is no such array; if Slurm does not answer, it is
// unknown, never ended.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "campaign/attempt_watch.h"
#include "execute/executor.h"
#include "execute/slurm_client.h"
#include "execute/slurm_journal.h"

namespace colloid {

class SlurmJobs : public AttemptWatch {
 public:
  /// Reads the journal; asks nobody yet.
  SlurmJobs(const SlurmClient& client, const SlurmJournal& journal);

  /// Asks Slurm.  An answer to sbatch that was lost is found by the job's name.
  void ask();
  /// The same, and writes such answers down.
  void refresh();

  std::optional<int> waiting(const std::string& realisation_folder) override;
  Presence presence(const std::string& attempt_folder) const override;
  Presence conclude(const std::string& attempt_folder) override;

  /// Takes in one that sbatch accepted just now, or whose answer was lost.  Its number
  /// for has_job, until something is closed.
  std::size_t add(Submission submission);
  /// Has Slurm said that it has the job?
  bool has_job(std::size_t submission) const {
    return !submissions_[submission].jobs.empty();
  }
  /// Closes those of which nothing runs and every attempt has an end.
  void close_ended();

  bool empty() const { return submissions_.empty(); }
  /// Did Slurm answer when it was asked last?
  bool answered() const { return answered_; }

  struct Counts {
    long waiting = 0;
    long running = 0;
    long unknown = 0;
    std::map<std::string, long> reasons;  ///< why tasks wait
  };
  Counts counts() const;  ///< of tasks

  /// Politely: running attempts write checkpoints as far as the site's KillWait lets
  /// them.  It still has to be asked whether they have stopped.
  void cancel(Stop how) const;

 private:
  enum class State { waiting, running, unknown, ended };
  struct Task {
    State state = State::unknown;
    std::string word;    ///< Slurm's
    std::string reason;  ///< why it waits
  };
  struct Known {
    Submission submission;
    std::vector<std::int64_t> jobs;  ///< more than one if it was accepted twice
    std::vector<Task> tasks;
  };
  using Place = std::pair<std::size_t, std::size_t>;  ///< submission, task

  void remember(std::size_t submission);
  void update(Known& known, const std::vector<SlurmTask>& listed) const;
  /// The task that runs the attempt, or has run it last; null if it is none of ours.
  const Task* task_of(const std::string& attempt_folder) const;
  /// The state of the tasks together: active if one is, unknown if one is.
  const Task* combined(const std::vector<Place>& places) const;

  const SlurmClient& client_;
  const SlurmJournal& journal_;
  std::vector<Known> submissions_;
  std::unordered_map<std::string, Place> attempts_;  ///< listed ones
  std::unordered_map<std::string, std::vector<Place>> realisations_;
  bool answered_ = false;
};

}  // namespace colloid
