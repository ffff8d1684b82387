// What a run of the tier transient will cost, before it is begun: cells times steps.
#pragma once

#include <string>

#include "scene/scene.h"
#include "tiers/regime.h"

namespace colloid {

struct TransientCost {
  double cells = 0.0;    ///< on average over the run
  double steps = 0.0;    ///< of the flow
  double seconds = 0.0;  ///< of one core
};

/// Cells: the liquid at the base cell, refined around grains (wall_refinement) and around
/// the colloids that are there on average.  Steps: the duration over the time in which
/// the fastest liquid, or a settling colloid, crosses `courant` of the smallest cell. The
/// deposit, which makes the liquid faster, is left out: long runs take longer.  Needs
/// colloids.
TransientCost predict_transient_cost(const Scene& scene, const Regime& regime);

/// "about 7e+04 steps of 8e+04 cells, 5.1 core-hours".
std::string cost_text(const TransientCost& cost);

}  // namespace colloid
