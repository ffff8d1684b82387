// Drag on a periodic array of fixed spheres.
#pragma once

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flow_scenes.h"

namespace colloid {

// Zick & Homsy (1982), table 2: K of F = 6 pi mu a K U at c = 0.125.
constexpr double kFraction = 0.125;
constexpr double kReference = 4.292;

struct ArrayDrag {
  double coefficient = 0.0;  // K
  double balance = 0.0;      // force on the sphere over that on the liquid
  double cells_per_diameter = 0.0;
};

/// Of spheres that are `shift` cells off the grid's symmetry.
inline ArrayDrag array_drag(int cells, double shift, double dt) {
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

/// 3 % at ten cells per diameter, of second order.  Returns the error.
inline double expect_array(int cells) {
  const ArrayDrag found = array_drag(cells, 0.0, 1e-3);
  const double error = found.coefficient / kReference - 1.0;
  std::printf("%.1f cells per diameter: K %.4f, %+.2f %%\n", found.cells_per_diameter,
              found.coefficient, 100.0 * error);
  EXPECT_NEAR(error, 0.0, 3.0 / (found.cells_per_diameter * found.cells_per_diameter))
      << found.cells_per_diameter << " cells per diameter";
  return error;
}

}  // namespace colloid
