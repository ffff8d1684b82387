// Speeds and sizes of a solved flow, for the regime.
#pragma once

#include "flow/stokes_solver.h"
#include "tiers/regime.h"

namespace colloid {

/// `flow_rate` [m^3/s] along the flow's axis, `critical_diameter` [m] of the pore.
FlowScales flow_scales(const StokesSolver& solver, double flow_rate,
                       double critical_diameter);

}  // namespace colloid
