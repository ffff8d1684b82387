// Scenes with bodies, as `measure` is asked for them.
#pragma once

#include <cmath>
#include <vector>

#include "core/constants.h"
#include "tiers/measurement.h"

namespace colloid::cases {

constexpr double kBodyRadius = 1e-5;  // [m]
constexpr double kBodyMu = 1e-3;      // [Pa s]
const double kBodyDrag = 6.0 * kPi * kBodyMu * kBodyRadius;
const double kBodyTurn = 8.0 * kPi * kBodyMu * kBodyRadius * kBodyRadius * kBodyRadius;

/// A cube of `extent` radii.
inline Scene cube_of_liquid(int extent, FaceCondition sides, FaceCondition below,
                            FaceCondition above) {
  Scene scene;
  const double edge = extent * kBodyRadius;
  scene.geometry.box.size = {edge, edge, edge};
  scene.geometry.box.faces = {sides, sides, sides, sides, below, above};
  scene.fluid.viscosity = kBodyMu;
  return scene;
}

inline void add_body(Scene& scene, const Vec3& centre, double radius = kBodyRadius) {
  Body body;
  body.sphere = {centre, radius};
  scene.geometry.bodies.push_back(body);
}

/// On `cells` per radius.
inline Measurement measured(const Scene& scene, int cells_per_radius) {
  MeasureOptions options;
  std::array<int, 3> cells{};
  for (std::size_t a = 0; a < 3; ++a) {
    cells[a] = static_cast<int>(std::lround(scene.geometry.box.size[static_cast<int>(a)] /
                                            kBodyRadius * cells_per_radius));
  }
  options.grid.cells = cells;
  return measure(scene, options);
}

}  // namespace colloid::cases
