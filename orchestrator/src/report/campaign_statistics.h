// The statistics of a whole campaign: every design point and tier, and paired differences
// between them.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "campaign/run_folder.h"
#include "report/read_ensemble.h"
#include "statistics/summary.h"

namespace colloid {

/// One ensemble, read and summarised.
struct EnsembleStatistics {
  std::size_t ensemble = 0;  ///< of the plan
  EnsembleSample sample;
  statistics::PointStatistics summary;
};

// NOLINTNEXTLINE(bugprone-exception-escape): moving a JSON object is said to throw
struct CampaignStatistics {
  std::vector<EnsembleStatistics> ensembles;
  nlohmann::ordered_json json;  ///< what `poreclog statistics --json` prints
};

/// InputError if the database does not hold the campaign.
CampaignStatistics campaign_statistics(const Plan& plan, const RunFolder& folder,
                                       const std::string& database);

/// Options of `summarise` that a campaign's author sets; resamples are fewer in large
/// ensembles, and `warnings` says so.
statistics::BootstrapOptions bootstrap_options(double confidence, std::size_t resamples,
                                               std::uint64_t seed, std::size_t n,
                                               std::vector<std::string>& warnings);

/// The headline numbers as lines for a terminal, from `poreclog statistics --json`.
std::string headlines(const nlohmann::ordered_json& statistics);

}  // namespace colloid
