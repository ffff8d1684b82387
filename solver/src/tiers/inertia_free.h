// What the tiers without inertia share: the scene made ready for their time loop.
#pragma once

#include <vector>

#include "particles/one_way_motion.h"
#include "scene/scene.h"
#include "tiers/deposit_flow.h"
#include "tiers/injection.h"
#include "tiers/regime.h"
#include "tiers/run_options.h"
#include "tiers/surface_model.h"
#include "tiers/time_loop.h"

namespace colloid {

/// Not to be moved: its parts refer to each other.
struct InertiaFreeScene {
  /// Refuses a scene in which inertia counts, on behalf of `tier`.
  InertiaFreeScene(const Scene& scene, const RunOptions& options, const char* tier);
  InertiaFreeScene(const InertiaFreeScene&) = delete;
  InertiaFreeScene& operator=(const InertiaFreeScene&) = delete;

  /// With or without hindrance by surfaces and by other colloids.
  OneWayOptions motion_options(bool wall_hindrance, bool pair_hindrance) const;
  LoopParts loop_parts(const RunOptions& options, MotionModel& motion);

  const Scene& scene;
  const char* tier;
  double radius;  ///< a of every colloid [m]
  CleanInlet inlet;
  InjectionPlan plan;
  DepositFlow flow;
  Regime regime;
  SurfaceModel contacts;
  FixedSurfaces surfaces;
  std::vector<double> grain_radii;  ///< [m]
};

}  // namespace colloid
