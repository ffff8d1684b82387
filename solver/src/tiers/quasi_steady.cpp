#include "tiers/quasi_steady.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "tiers/inertia_free.h"
#include "tiers/resolved_motion.h"

namespace colloid {

namespace {

// Travel between two solves, in cells.
constexpr double kMostTravel = 0.5;

// Of a solve, relative: moves trajectories by a hundredth of what the step of half a cell
// does.
constexpr double kTolerance = 1e-3;

// MODEL (Q4).
void refuse_brownian(const ModelDecision& brownian) {
  require(!brownian.needed, "/fidelity/tier", [&] {
    return fmt::format(
        "the tier quasi_steady has no Brownian motion, but {}; expected \"one_way\"",
        brownian.reason);
  });
}

}  // namespace

std::optional<Realisation> run_quasi_steady(const Scene& scene,
                                            const RunOptions& options) {
  InertiaFreeScene ready(scene, options, "quasi_steady");
  refuse_brownian(ready.regime.colloids->models.brownian);
  const bool full = scene.fidelity.lubrication == Lubrication::full;
  const OneWayMotion model(ready.motion_options(full, full), ready.flow, ready.surfaces,
                           ready.grain_radii);
  const StokesSolver& clean = ready.flow.solver();
  const double cell = clean.length_unit();
  ResolvedOptions resolved;
  resolved.radius = ready.radius;
  resolved.most_travel = kMostTravel * cell;
  resolved.cell = full ? cell : 0.0;
  resolved.tolerance = std::max(kTolerance, scene.fidelity.tolerance);
  resolved.threads = options.threads;
  ResolvedMotion motion(resolved, clean.problem(), model);
  return TimeLoop(scene, options, ready.loop_parts(options, motion)).run();
}

}  // namespace colloid
