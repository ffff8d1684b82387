// How long a Brownian colloid waits outside an energy barrier before it gets over it into
// the primary minimum.
#pragma once

#include "physics/pair_analysis.h"
#include "physics/surface_pair.h"

namespace colloid {

struct EscapeConditions {
  double viscosity = 1.002e-3;  ///< mu [Pa s]
  double force_towards = 0.0;  ///< constant force on the colloid [N], > 0: to the surface
};

struct BarrierEscape {
  double time = 0.0;        ///< mean time to reach the primary minimum [s], or infinity
  double barrier_kT = 0.0;  ///< height of the barrier above the start, with the force [-]
  double start_gap = 0.0;   ///< gap of the start [m]
};

/// Exact mean first passage time, MODEL (S15), (S16), in the curve W(h) = E(h) +
/// force_towards h, with the diffusivity kT/(6 pi mu a f) where f is f_n(h/a) for a plate
/// and xa11 for a second sphere, held; radius and temperature are those of `forces`.
///
/// It starts at the bottom of the well outside the barrier (the secondary minimum, or the
/// place where the force holds the colloid against the barrier) and ends 60 kT downhill
/// of the barrier or at the primary minimum.  The colloid stays: it is reflected at the
/// top of the curve outside the well (a force away from the surface), or at a gap of one
/// radius.
///
/// Infinite without a primary minimum, where nothing holds the colloid outside the
/// barrier, and beyond 1e300 s.  Where the curve goes downhill all the way the time is
/// that from one Debye length outside the barrier of the curve without the force, or
/// outside the primary minimum if there is none.
///
/// About a millisecond; some tens of them where the curve spans thousands of kT.
BarrierEscape barrier_escape(const SurfaceForces& forces, const PairAnalysis& analysis,
                             const EscapeConditions& conditions);

}  // namespace colloid
