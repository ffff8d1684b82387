// Everything that a report shows, as one JSON object: statistics, samples of rows, two
// realisations to look at, provenance.  The page (page/page.js) draws it.
//
// Its size does not grow with the ensemble: rows and points are sampled beyond some
// hundreds, evenly in seed order, and the report says so.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "campaign/run_folder.h"
#include "campaign/solver_program.h"
#include "report/campaign_statistics.h"

namespace colloid {

/// `solver` is asked for the regime of each scene; without it the report has none.
nlohmann::ordered_json report_content(const Plan& plan, const RunFolder& folder,
                                      const std::string& database,
                                      const CampaignStatistics& statistics,
                                      const std::optional<SolverProgram>& solver);

}  // namespace colloid
