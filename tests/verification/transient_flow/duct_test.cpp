// A free sphere in a square duct: see README.md beside this file.
#include <gtest/gtest.h>

#include "duct_case.h"

namespace colloid {
namespace {

TEST(TransientDuct, DragsASphereFixedOnItsAxis) {
  expect_duct_drag(0.4, 20);
  expect_duct_drag(0.4, 25);
}

TEST(TransientDuct, CarriesAFreeSphereOnItsAxis) {
  expect_duct(0.4, 0.0, 16);
}

TEST(TransientDuct, CarriesAFreeSphereOffItsAxis) {
  expect_duct(0.4, 0.15, 16);
  expect_duct(0.4, 0.15, 24);
}

// Inertia moves it sideways by 1e-5 of its way, so it must not be seen to move: by no
// more than the grid's own error at the step in use, which is that of a sphere held at
// its place, twice for that of two cells; and by less at a tenth of the step.
TEST(TransientDuct, KeepsAFreeSphereOnItsLine) {
  constexpr double kOffset = 0.15;
  DuctSphere long_steps(0.4, kOffset, 16);
  DuctSphere short_steps(0.4, kOffset, 16);
  const double grid = std::abs(long_steps.held().sideways);
  short_steps.held();
  const double drift = long_steps.drift(0.3);
  const double rest = short_steps.drift(0.03);
  std::printf(
      "drift %.2e and %.2e of the way at Courant numbers 0.3 and 0.03, %.1e held\n",
      drift, rest, grid);
  EXPECT_LT(std::abs(drift), 2.0 * grid);
  EXPECT_LT(std::abs(rest), grid);
}

// Periodic along z, walls on the grid; k over W^2.
double permeability(int cells, bool square) {
  constexpr double kWidth = 1e-4;
  constexpr double kForce = 10.0;
  const FaceCondition beside = square ? kWall : kPeriodic;
  Scene scene;
  scene.geometry.box = {{kWidth, kWidth, 0.25 * kWidth},
                        {kWall, kWall, beside, beside, kPeriodic, kPeriodic}};
  scene.drive.body_force = Vec3{0.0, 0.0, kForce};
  TransientFlow flow(scene, base_cells(cells, square ? cells : 2, cells / 4, 0));
  flow.settle(1e-2, 1e-7, 100, {});
  return flow.mean_velocity().z * scene.fluid.viscosity / (kForce * kWidth * kWidth);
}

// Finite volumes with walls half a cell beside the first unknown solve a channel exactly
// but for a slip of h^2/8 (u_1 = h/4 by the balance of the first cell, h/4 - h^2/8
// exact), and the mean of n midpoints is h^2/24 more than that of the parabola: k = (1 +
// 2/n^2)/12.
TEST(TransientDuct, HasAChannelsPermeabilityWithItsExactError) {
  for (const int cells : {8, 10, 16, 20}) {
    EXPECT_NEAR(12.0 * permeability(cells, false), 1.0 + 2.0 / (cells * cells), 2e-5)
        << cells;
  }
}

// In a square duct the same slip and midpoints make h^2/6 of k/W^2 = 0.0351, 4.74/n^2,
// less what the second differences miss inside; of second order.
TEST(TransientDuct, HasItsPermeability) {
  double coarsest = 0.0;
  for (const int cells : {8, 10, 16, 20}) {
    const double error = permeability(cells, true) / kDuctPermeability - 1.0;
    const double coefficient = error * cells * cells;
    std::printf("%d cells: %+.3f %%\n", cells, 100.0 * error);
    EXPECT_GT(coefficient, 0.0) << cells;
    EXPECT_LT(coefficient, 4.74) << cells;
    coarsest = cells == 8 ? coefficient : coarsest;
    EXPECT_NEAR(coefficient / coarsest, 1.0, 0.1) << cells;
  }
}

}  // namespace
}  // namespace colloid
