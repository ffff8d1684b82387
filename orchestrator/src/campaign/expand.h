// From a campaign to a plan: its design points, each with its scene spelled out and
// checked by the solver.
#pragma once

#include "campaign/campaign.h"
#include "campaign/plan.h"
#include "campaign/solver_program.h"

namespace colloid {

/// The product of the varied values, the last pointer (in alphabetical order) fastest, in
/// every tier.  A scene that the solver refuses is refused with the place in the
/// campaign's or the scene's file that caused it.
Plan expand(const Campaign& campaign, const SolverProgram& solver);

}  // namespace colloid
