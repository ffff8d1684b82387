// Drag on a colloid held in the throat, on grids refined around it and everywhere.
#pragma once

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flow_scenes.h"

namespace colloid {

struct HeldDrag {
  Vec3 force;
  long cells = 0;
};

inline HeldDrag held_in_throat(int base, int refinement, int at_grains) {
  const Scene scene = throat_scene(5e-4);
  TransientFlowOptions options = base_cells(base, base, base * 3 / 2, refinement);
  options.wall_refinement = at_grains;
  TransientFlow flow(scene, options);
  FlowBody body;
  body.sphere = {{60e-6, 52e-6, 75e-6}, 6.65e-6};
  flow.settle(2e-4, 3e-4, 40, {body});
  return {flow.step(2e-4, {body})[0].force, flow.counts().cells};
}

/// The difference of both over the force; `at_grains`: as wall_refinement.
inline double refinement_error(int base, int at_grains) {
  const HeldDrag near = held_in_throat(base, 1, at_grains);
  const HeldDrag everywhere = held_in_throat(2 * base, 0, 0);
  EXPECT_LT(near.cells, everywhere.cells);
  const double difference = norm(near.force - everywhere.force) / norm(everywhere.force);
  std::printf(
      "%d cells across, %ld refined near, %ld everywhere: drag differs by %.3f %%\n",
      base, near.cells, everywhere.cells, 100.0 * difference);
  return difference;
}

/// What the coarse cells do to the flow around: second order, 3 % at ten across the
/// throat's 40 um of the box's 96.6.
inline double refinement_bound(int base) {
  const double across = base * 40.0 / 96.6;
  return 0.03 * 100.0 / (across * across);
}

}  // namespace colloid
