// A sphere held in shear flow near a plane wall.
#pragma once

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flow_scenes.h"

namespace colloid {

// Goldman, Cox & Brenner (1967), Chem. Eng. Sci. 22, 653, table 2: F over 6 pi mu a h S,
// T over 4 pi mu a^3 S at the height h of the centre, over a.
struct ShearRow {
  double height, force, torque;
};
constexpr ShearRow kNear{1.5431, 1.4391, 0.97419};
constexpr ShearRow kFar{2.3524, 1.2780, 0.99010};

// The box of the test, in radii: a period along and across, the moving plane's height.
constexpr double kPeriod = 16.0;
constexpr double kHeight = 12.0;

// x velocity at (x, y, z) of a Stokeslet along x at (0, 0, h) beside the wall z = 0,
// times 8 pi mu over its force.  Blake (1971), Proc. Camb. Phil. Soc. 70, 303.
inline double beside_wall(double x, double y, double z, double h) {
  const double r = std::sqrt(x * x + y * y + (z - h) * (z - h));
  const double up = z + h;
  const double image = std::sqrt(x * x + y * y + up * up);
  const auto cubed = [](double v) { return v * v * v; };
  const double fifth = cubed(image) * image * image;
  const double doublet = h * (1.0 / cubed(image) - 3.0 * x * x / fifth) -
                         (up / cubed(image) - 3.0 * x * x * up / fifth);
  return 1.0 / r + x * x / cubed(r) - 1.0 / image - x * x / cubed(image) +
         2.0 * h * doublet;
}

// The shear that the sphere feels in the periodic box over that of the plane: its images
// take some away, and as the plane's speed is given, not its stress, the mean of all
// gives some.  `at_force`: of the velocity; else of its slope.  The first reflection.
inline double shear_in_box(const ShearRow& row, bool at_force) {
  const double h = row.height;
  constexpr int kImages = 60;
  const auto images = [&](double z) {
    double sum = 0.0;
    for (int i = -kImages; i <= kImages; ++i) {
      for (int j = -kImages; j <= kImages; ++j) {
        if (i * i + j * j > 0 && i * i + j * j <= kImages * kImages) {
          sum += beside_wall(i * kPeriod, j * kPeriod, z, h);
        }
      }
    }
    // Beyond: 12 h z x^2/r^5 over the plane.
    return sum + 12.0 * h * z * kPi / (kImages * kPeriod) / (kPeriod * kPeriod);
  };
  constexpr double kDifference = 1e-3;
  const double per_height =
      at_force
          ? images(h) / h
          : (images(h + kDifference) - images(h - kDifference)) / (2.0 * kDifference);
  const double force = 6.0 * kPi * row.force * h;
  return 1.0 - force / (8.0 * kPi) * per_height +
         force * h / (kPeriod * kPeriod * kHeight);
}

/// `refinement` 1, 2, 3: 5, 10, 20 cells per diameter.
inline void expect_shear(const ShearRow& row, int refinement) {
  constexpr double kRadius = 5e-6;
  constexpr double kShear = 10.0;  // [1/s]: Re 2.5e-4
  Scene scene;
  scene.geometry.box = {{kPeriod * kRadius, kPeriod * kRadius, kHeight * kRadius},
                        {kPeriodic, kPeriodic, kPeriodic, kPeriodic, kWall, kWall}};
  scene.drive.shear_rate = kShear;
  TransientFlow flow(scene, base_cells(20, 20, 15, refinement));
  FlowBody body;
  body.sphere = {{8.03 * kRadius, 7.95 * kRadius, row.height * kRadius}, kRadius};
  // A viscous time over the height: 0.36 ms by its slowest mode.
  flow.settle(2e-4, 1e-5, 60, {body});
  const FlowResponse found = flow.step(2e-4, {body})[0];
  const double mu = scene.fluid.viscosity;
  const double force = found.force.x / (6.0 * kPi * mu * kRadius * row.height * kRadius *
                                        kShear * shear_in_box(row, true));
  const double torque = found.torque.y / (4.0 * kPi * mu * std::pow(kRadius, 3) * kShear *
                                          shear_in_box(row, false));
  const double cells = 2.0 * kRadius / flow.cell_at_bodies();
  std::printf(
      "h/a %.4f, %.0f cells per diameter, %ld cells: force %.4f (%.4f), torque "
      "%.4f (%.4f)\n",
      row.height, cells, flow.counts().cells, force, row.force, torque, row.torque);
  // Second order, 3 % at ten cells as of the drag on an array; the box: second
  // reflections, a twentieth of the first, of at most 7 %.
  const double bound = 0.03 * 100.0 / (cells * cells) + 0.004;
  EXPECT_NEAR(force / row.force, 1.0, bound);
  EXPECT_NEAR(torque / row.torque, 1.0, bound);
  EXPECT_LT(std::abs(found.force.y), 2e-3 * found.force.x);
}

}  // namespace colloid
