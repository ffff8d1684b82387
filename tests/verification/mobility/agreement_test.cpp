// Where the tier one_way has to agree with the resolved flow: see README.md.
#include <gtest/gtest.h>

#include "scene/read_scene.h"
#include "tiers/inertia_free.h"
#include "tiers/resolved_motion.h"

namespace colloid {
namespace {

// A duct twenty colloids wide, nothing in it.
Scene wide_duct(int cells_per_colloid) {
  return parse_scene(R"({
    "geometry": {"box": ["80 um", "80 um", "80 um"],
                 "faces": {"x-": "wall", "x+": "wall", "y-": "wall", "y+": "wall",
                           "z-": "outlet", "z+": "inlet"}, "spheres": []},
    "drive": {"inlet_velocity": "0.5 mm/s"}, "gravity": ["0 m/s^2", "0 m/s^2", "0 m/s^2"],
    "colloids": {"diameter": "4 um", "density": "1000 kg/m^3", "volume_fraction": 1e-6},
    "duration": "1 s",
    "fidelity": {"tier": "quasi_steady", "cells_per_colloid": )" +
                         std::to_string(cells_per_colloid) + "}}",
                     "duct.json")
      .scene;
}

// Far from walls a free sphere moves with the Faxen average of the flow; walls at h slow
// it by (5/16) (a/h)^3 of the shear's part, below a thousandth here.
TEST(Agreement, ALonelyColloidFarFromWallsMovesAsInTheTierOneWay) {
  double before = 0.0;
  for (const auto& [cells, bound] : {std::pair{2, 0.02}, std::pair{4, 0.004}}) {
    const Scene scene = wide_duct(cells);
    InertiaFreeScene ready(scene, RunOptions{}, "quasi_steady");
    const OneWayMotion one_way(ready.motion_options(true, true), ready.flow,
                               ready.surfaces, {});
    ResolvedOptions options;
    options.radius = ready.radius;
    options.cell = ready.flow.solver().length_unit();
    options.most_travel = 0.5 * options.cell;
    options.tolerance = 1e-6;
    ResolvedMotion resolved(options, ready.flow.solver().problem(), one_way);
    double worst = 0.0;
    for (const Vec3& x : {Vec3{41e-6, 39e-6, 30e-6}, Vec3{24e-6, 33e-6, 41e-6}}) {
      const std::vector<RigidBody> bodies{single(MobileColloid{0, 0.0, x}, x)};
      const Motion faxen = one_way.motion(bodies, {}, {});
      ASSERT_TRUE(resolved.begin_step(bodies, {}, faxen));
      const Motion found = resolved.motion(bodies, {}, {});
      worst = std::max(
          worst, norm(found.velocity[0] - faxen.velocity[0]) / norm(faxen.velocity[0]));
    }
    EXPECT_LT(worst, bound) << cells;
    if (before > 0.0) {
      EXPECT_LT(worst, before);
    }
    before = worst;
  }
}

}  // namespace
}  // namespace colloid
