// What --dry-run says of a campaign that goes to Slurm.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "campaign/run_folder.h"

namespace colloid {

class SlurmClient;

/// What would be sent for so many realisations: the limits that were read, the layout and
/// its reasons, the first command and its script.
nlohmann::ordered_json slurm_plan(const Plan& plan, const RunFolder& folder,
                                  const SlurmClient& client, long realisations);

/// The same for people.
std::string slurm_plan_text(const nlohmann::ordered_json& planned);

}  // namespace colloid
