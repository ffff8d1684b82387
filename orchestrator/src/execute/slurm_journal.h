// What has been sent to Slurm, on the disk before it is sent.
//
//     <runs>/<campaign>/slurm/000001/submission.json   the job's name, the time
//     .../list                                         attempts' folders, one a line
//     .../script                                       what sbatch got
//     .../job                                          its answer: the array's id
//     .../output                                       of the tasks' script
//     .../closed                                       nothing of it runs any more
//
// A folder is whole or absent (it is renamed into place).  Without the file `job` the
// answer was not seen, and Slurm is asked for the name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace colloid {

struct Submission {
  int number = 0;
  std::string folder;
  std::string name;                   ///< of the job; no other has it
  long per_task = 1;                  ///< lines of the list that one task runs
  std::vector<std::string> attempts;  ///< the list
  std::optional<std::int64_t> job;    ///< of the array, if the answer was seen
};

class SlurmJournal {
 public:
  /// `folder`: the campaign's run folder; `campaign` becomes part of the jobs' names.
  SlurmJournal(const std::string& folder, std::string campaign);

  /// Those that are not closed, in the order in which they were sent.
  std::vector<Submission> open() const;

  /// Where the next submission will be, and its job's name.
  Submission next() const;
  /// Writes it down, with its script, and waits for the disk.
  void begin(const Submission& submission, const std::string& script) const;
  void accept(Submission& submission, std::int64_t job) const;
  void close(const Submission& submission) const;

 private:
  std::string folder_;
  std::string campaign_;
};

}  // namespace colloid
