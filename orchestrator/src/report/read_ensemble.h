// The realisations of one design point and tier, from the database, as the statistics
// take them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/plan.h"
#include "campaign/run_folder.h"
#include "statistics/outcome.h"
#include "store/database.h"

namespace colloid {

/// Curves (and the critical diameter lost to the first retention) are read of the first
/// so many realisations, in seed order: a choice that does not depend on the outcome.
constexpr std::size_t kMostCurves = 5000;

/// What of an unfinished ensemble is looked at, and how.
enum class InterimRule {
  complete,          ///< every realisation has finished or failed
  running_censored,  ///< survival counts the unfinished ones, censored at their last
                     ///< checkpoint; everything else the complete prefix in seed order
  complete_prefix    ///< the complete prefix alone: some that run have no checkpoint yet
};

const char* description_of(InterimRule rule);

struct EnsembleSample {
  std::int64_t id = 0;  ///< of the ensemble in the database
  std::string tier;     ///< that ran; as asked for if none or several did
  std::vector<statistics::RealisationOutcome> outcomes;  ///< in seed order
  InterimRule rule = InterimRule::complete;
  std::size_t n_running = 0;
  std::size_t n_pending = 0;
  std::size_t n_beyond_prefix = 0;  ///< finished, after one that has not
  std::size_t n_with_curve = 0;
};

/// None if the database does not hold the ensemble.  Realisations from index `wanted` on
/// that have not begun are not waited for: the campaign's target is met without them.
std::optional<EnsembleSample> read_ensemble(const Database& database, const Plan& plan,
                                            std::size_t ensemble, const RunFolder& folder,
                                            int wanted);

}  // namespace colloid
