// How realisations are put into job arrays: numbers in, numbers and words out.
#pragma once

#include <string>
#include <vector>

#include "campaign/plan.h"
#include "execute/slurm_client.h"

namespace colloid {

/// The shape of a campaign's arrays, and why it is so.
struct SlurmLayout {
  long per_task = 1;     ///< realisations of one task, one after another
  long array_tasks = 1;  ///< of one array, at most
  long tasks = 1;        ///< in the queue at once, at most
  int at_once = 0;       ///< tasks of one array at once; 0: as many as Slurm likes
  long minutes = 1;      ///< time limit of a task
  std::vector<std::string> reasons;
};

/// The layout for `realisations` that may have to be run.
///
/// An array holds a thousand realisations or more if there are as many, so that there is
/// one sbatch per thousand at most.  The campaign's tasks take half of the controller's
/// job table at most; beyond that a task runs several realisations one after another, as
/// far as the partition's time limit allows.  What does not fit waits for the next
/// `resume`.
SlurmLayout slurm_layout(const Plan& plan, const SlurmLimits& limits, long realisations);

/// The words for sbatch of an array of `tasks` tasks.
std::vector<std::string> sbatch_words(const Plan& plan, const SlurmLayout& layout,
                                      const std::string& name, const std::string& folder,
                                      long tasks);

/// The script of an array.  It reads the list, whose lines are attempts' folders.
std::string batch_script(const Plan& plan, const SlurmLayout& layout,
                         const std::string& folder, const std::string& keeper);

}  // namespace colloid
