// The ending of an attempt whose task is gone and has left none.
#pragma once

#include <string>

namespace colloid {

/// Writes it, so that no task can begin the attempt any more.  `word`: the task's state
/// as Slurm says it (FAILED, TIMEOUT, ...), empty if Slurm knows it no more; `reason`:
/// Slurm's.
void write_slurm_ending(const std::string& attempt_folder, const std::string& word,
                        const std::string& reason);

}  // namespace colloid
