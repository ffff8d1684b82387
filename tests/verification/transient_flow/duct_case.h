// A free sphere in a long square duct, in time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "flow_scenes.h"
#include "sphere_in_duct/duct_reference.h"

namespace colloid {

struct DuctFound {
  double speed = 0.0, spin = 0.0;  ///< as DuctMotion
  double sideways = 0.0;           ///< velocity towards the wall over that along the axis
  double across = 0.0;             ///< the same of the other direction
  /// Way sideways over that along the axis, let go: at Courant numbers 0.3 and 0.1.
  double drifted = 0.0, drifted_slowly = 0.0;
};

/// Neutrally buoyant, in a periodic duct two widths long, at the reference Reynolds
/// number (0.1 of width and largest speed): held at its place until it has come to its
/// motion, then let go over three cells.
inline DuctFound free_in_duct(double size, double offset, int cells) {
  constexpr double kWidth = 1e-4;
  constexpr double kSpeed = 1e-3;
  constexpr double kStep = 2e-4;  // the flow's slowest mode dies in 5e-4 s
  Scene scene;
  scene.geometry.box = {{kWidth, kWidth, 2.0 * kWidth},
                        {kWall, kWall, kWall, kWall, kPeriodic, kPeriodic}};
  const double slope = 1e-3 * kSpeed / kDuctPeak / (kDuctPermeability * kWidth * kWidth);
  scene.drive.body_force = Vec3{0.0, 0.0, slope};
  scene.fluid.density = 1000.0;
  scene.fluid.viscosity = 1e-3;
  TransientFlow flow(scene, base_cells(cells, cells, 2 * cells, 0));
  const double h = kWidth / cells;
  const double a = 0.5 * size * kWidth;
  std::vector<FlowBody> bodies{
      free_sphere({(0.5 + offset) * kWidth, 0.5 * kWidth, kWidth + 0.3 * h}, a, 1000.0)};
  FlowBody& body = bodies[0];
  const auto step = [&](double dt) {
    const Vec3 before = body.velocity;
    const FlowResponse moved = flow.step(dt, bodies)[0];
    body.velocity = moved.velocity;
    body.spin = moved.spin;
    return norm(body.velocity - before) / norm(body.velocity);
  };
  for (int n = 0; n < 60 && step(kStep) > 1e-4;) {
    ++n;
  }
  DuctFound out;
  // To the developed flow's flux.
  const double scale = 1.0 / (kDuctPeak * flow.mean_velocity().z);
  out.speed = scale * body.velocity.z;
  out.spin = scale * a * body.spin.y;
  out.sideways = body.velocity.x / body.velocity.z;
  out.across = body.velocity.y / body.velocity.z;
  const auto drift = [&](double courant, double cells_on) {
    const Vec3 start = body.sphere.center;
    while (body.sphere.center.z - start.z < cells_on * h) {
      const double dt = courant * flow.courant_time();
      step(dt);
      body.sphere.center += dt * body.velocity;
    }
    const Vec3 way = body.sphere.center - start;
    return way.x / way.z;
  };
  out.drifted = drift(0.3, 2.0);
  out.drifted_slowly = drift(0.1, 1.0);
  return out;
}

// Largest drift of a sphere let go: measured (2.7e-3 and 2.1e-3 at 6.4 and 9.6 cells per
// diameter, 1.7e-3 with two passes), so a record that guards against worse, no
// verification.  Smaller steps and a second pass make it smaller; that it is nothing but
// the splitting of momentum and pressure is not shown.
constexpr double kDriftOnRecord = 4e-3;

/// Against reference.csv: 1 % at 12 cells per diameter, second order, as the tier
/// quasi_steady's; sideways, where there is nothing to resolve, a tenth of it.
inline void expect_duct(double size, double offset, int cells) {
  for (const DuctReference& r : square_ducts()) {
    if (r.size != size || r.offset != offset) {
      continue;
    }
    const DuctMotion exact = free_motion(r);
    const DuctFound found = free_in_duct(size, offset, cells);
    const double per_diameter = cells * size;
    const double bound = 0.01 * 144.0 / (per_diameter * per_diameter) + r.residual;
    std::printf(
        "offset %.2f, %.1f cells per diameter: speed %.5f exact %.5f, spin %.5f "
        "exact %.5f, sideways %.1e, across %.1e, drifted %.1e %.1e\n",
        offset, per_diameter, found.speed, exact.speed, found.spin, exact.spin,
        found.sideways, found.across, found.drifted, found.drifted_slowly);
    EXPECT_NEAR(found.speed / exact.speed, 1.0, bound);
    EXPECT_NEAR(found.spin, exact.spin, bound * exact.speed);
    EXPECT_NEAR(found.sideways, 0.0, 0.1 * bound);
    EXPECT_NEAR(found.across, 0.0, 1e-5);
    EXPECT_NEAR(found.drifted, 0.0, kDriftOnRecord);
    EXPECT_NEAR(found.drifted_slowly, 0.0, kDriftOnRecord);
    return;
  }
  FAIL() << "no such row in reference.csv";
}

}  // namespace colloid
