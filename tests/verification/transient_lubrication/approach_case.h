// What the transient flow alone resists with where a sphere approaches a plane wall.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/constants.h"
#include "physics/wall_resistance.h"
#include "tiers/transient/transient_flow.h"

namespace colloid {

constexpr double kApproachRadius = 5e-6;  // [m]

/// Where the sphere's axis lies between the grid's planes, in cells.
using Place = std::array<double, 2>;

/// Force over 6 pi mu a U on a sphere that is moved towards a wall on the grid, in a
/// closed box of eight radii, at the gap of `gap` cells; `refinement`: cells per
/// diameter, 10 or 16.
inline double resolved_approach(int cells_per_diameter, double gap, const Place& place) {
  constexpr double kSpeed = 1e-5;
  constexpr FaceCondition kWall = FaceCondition::wall;
  const double a = kApproachRadius;
  const double h = 2.0 * a / cells_per_diameter;
  const int base = cells_per_diameter;  // two levels coarser: eight radii
  Scene scene;
  scene.geometry.box = {{8.0 * a, 8.0 * a, 8.0 * a},
                        {kWall, kWall, kWall, kWall, kWall, kWall}};
  TransientFlowOptions options;
  options.cells = {base, base, base};
  options.refinement = 2;
  TransientFlow flow(scene, options);
  FlowBody body;
  body.sphere = {{4.0 * a + place[0] * h, 4.0 * a + place[1] * h, a + gap * h}, a};
  body.velocity = {0.0, 0.0, -kSpeed};
  const double stokes = 6.0 * kPi * scene.fluid.viscosity * a * kSpeed;
  double force = 0.0;
  for (int n = 0; n < 60; ++n) {
    const double before = force;
    force = flow.step(1e-4, {body})[0].force.z / stokes;
    if (std::abs(force - before) < 3e-4 * force) {
      break;
    }
  }
  return force;
}

/// What the walls beside and above add: what the force at a gap so wide that the grid
/// sees all of it is more than that of one wall.
inline double far_walls(int cells_per_diameter, const Place& place) {
  constexpr double kWide = 5.0;  // cells
  return resolved_approach(cells_per_diameter, kWide, place) -
         wall_resistance(kWide * 2.0 / cells_per_diameter).f_n;
}

}  // namespace colloid
