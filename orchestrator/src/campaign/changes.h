// What a campaign may change between two runs, and what it may not.
#pragma once

#include <string>
#include <vector>

#include "campaign/plan.h"

namespace colloid {

/// What makes existing realisations of `old_plan` wrong in `new_plan`, one line each:
/// other scenes, seeds or ranks, design points or tiers that are no longer there.
/// Spelling (units, order of keys, remarks), limits, workers, options of the statistics,
/// more realisations, design points or tiers are no such changes.
std::vector<std::string> forbidden_changes(const Plan& old_plan, const Plan& new_plan);

/// `new_plan` with the numbers that design points have in `old_plan`, new ones behind,
/// and no fewer realisations than before.  Precondition: no forbidden changes.
Plan continued(const Plan& old_plan, Plan new_plan);

}  // namespace colloid
