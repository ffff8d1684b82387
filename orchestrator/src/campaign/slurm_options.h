// What a campaign asks of Slurm, in its key "slurm".
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace colloid {

struct SlurmOptions {
  std::string partition;  ///< empty: the site's default
  std::string account;    ///< empty: the user's default
  int memory_MiB = 0;     ///< of one realisation, all ranks; 0: the site's default
  int realisations_per_task = 0;     ///< one after another; 0: as few as the limits allow
  std::string launcher = "mpirun";   ///< of several ranks: mpirun or srun
  std::vector<std::string> options;  ///< more words for sbatch, such as --qos=long
};

/// Reads and checks the key.  Everything here becomes a word of sbatch's command line,
/// which no shell sees; what does not look like what it claims to be is refused all the
/// same, and of sbatch's options only those are let through that say where a job runs and
/// what it gets, not what it does.
SlurmOptions read_slurm_options(const nlohmann::json& value, const std::string& pointer);

nlohmann::json to_json(const SlurmOptions& options);

}  // namespace colloid
