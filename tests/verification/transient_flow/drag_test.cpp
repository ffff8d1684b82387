// Drag on a periodic array of fixed spheres: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "flow_scenes.h"

namespace colloid {
namespace {

// Zick & Homsy (1982), table 2: K of F = 6 pi mu a K U at c = 0.125.
constexpr double kFraction = 0.125;
constexpr double kReference = 4.292;

struct Drag {
  double coefficient = 0.0;  // K
  double balance = 0.0;      // force on the sphere over that on the liquid
  double cells_per_diameter = 0.0;
};

Drag drag(int cells, double shift, double dt) {
  constexpr double kLength = 1e-4;
  const double a = kLength * std::cbrt(3.0 * kFraction / (4.0 * kPi));
  Scene scene;
  scene.geometry.box = {
      {kLength, kLength, kLength},
      {kPeriodic, kPeriodic, kPeriodic, kPeriodic, kPeriodic, kPeriodic}};
  const double h = kLength / cells;
  scene.geometry.spheres = {{{0.5 * kLength + shift * h, 0.5 * kLength + 0.7 * shift * h,
                              0.5 * kLength + 0.3 * shift * h},
                             a}};
  const double force = 100.0;  // per volume: Re 1e-3
  scene.drive.body_force = Vec3{0.0, 0.0, force};
  TransientFlow flow(scene, base_cells(cells, cells, cells, 0));
  flow.settle(dt, 1e-6, 300, {});
  const double total = force * kLength * kLength * kLength;
  return {total / (6.0 * kPi * 1e-3 * a * flow.mean_velocity().z),
          flow.grain_force().z / total, 2.0 * a / h};
}

TEST(TransientDrag, OfASimpleCubicArrayConvergesAtSecondOrder) {
  const Drag coarse = drag(16, 0.0, 1e-3);
  const Drag fine = drag(32, 0.0, 1e-3);
  const double coarse_error = coarse.coefficient / kReference - 1.0;
  const double fine_error = fine.coefficient / kReference - 1.0;
  EXPECT_NEAR(coarse_error, 0.0, 0.03)
      << coarse.cells_per_diameter << " cells per diameter";
  EXPECT_NEAR(fine_error, 0.0, 0.0075)
      << fine.cells_per_diameter << " cells per diameter";
  // A quarter each: at the finer grid a quarter of the coarser one's error is left.
  EXPECT_GT(std::abs(coarse_error), 2.8 * std::abs(fine_error));
}

TEST(TransientDrag, HardlyDependsOnThePlaceInTheGrid) {
  const double centred = drag(16, 0.0, 1e-3).coefficient;
  for (const double shift : {0.25, 0.5}) {
    EXPECT_NEAR(drag(16, shift, 1e-3).coefficient / centred, 1.0, 0.01) << shift;
  }
}

// A steady flow does not know the step by which it came to rest.
TEST(TransientDrag, DoesNotDependOnTheStep) {
  EXPECT_NEAR(drag(16, 0.0, 1e-4).coefficient / drag(16, 0.0, 1e-2).coefficient, 1.0,
              2e-3);
}

TEST(TransientDrag, BalancesTheForceOnTheLiquid) {
  EXPECT_NEAR(drag(16, 0.3, 1e-3).balance, 1.0, 2e-3);
}

}  // namespace
}  // namespace colloid
