// Two realisations of an ensemble to be looked at side by side: the first that clogged,
// and a late one.
#pragma once

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "campaign/run_folder.h"
#include "report/campaign_statistics.h"
#include "store/database.h"

namespace colloid {

/// [{"title", "idx", "seed", "t1_s", "tc_s", "series", "retained", "grains", "box_m"}]:
/// series, grains and box from the result file, null if that is gone.
nlohmann::ordered_json examples(const Database& database, const Plan& plan,
                                const EnsembleStatistics& of, const RunFolder& folder);

}  // namespace colloid
