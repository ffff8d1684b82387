// From a scene to the plan of its injections.                           MODEL section I
#pragma once

#include "particles/injection_sequence.h"
#include "scene/scene.h"

namespace colloid {

/// The flow into the clean pore and what it means for capture.  Found from the scene's
/// physics alone, never from its fidelity, so that no option changes the injections.
struct CleanInlet {
  double flow_rate = 0.0;    ///< Q into the box [m^3/s]; 0: the pore is blocked
  double mean_speed = 0.0;   ///< Q over the whole inlet face [m/s]
  double capture_gap = 0.0;  ///< colloid and grain, at the mean speed [m]; infinite at 0
};

/// Inlet velocity times area; where the drive is a pressure drop, or grains reach through
/// the inlet plane, the flow is solved, on the grid of the default fidelity.  Refuses a
/// scene without colloids or without an inlet.
CleanInlet clean_inlet(const Scene& scene);

/// The plan with that (physical) capture gap [m].  Refuses a scene without colloids, with
/// no or several inlet faces, and a colloid for which the inlet has no room.
InjectionPlan make_injection_plan(const Scene& scene, double capture_gap);

}  // namespace colloid
