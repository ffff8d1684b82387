// What the transient flow alone resists with where a sphere approaches a plane wall.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/constants.h"
#include "physics/pair_resistance.h"
#include "physics/wall_resistance.h"
#include "tiers/transient/dem_lubrication.h"
#include "tiers/transient/transient_flow.h"

namespace colloid {

constexpr double kApproachRadius = 5e-6;  // [m]

/// Where the sphere's axis lies between the grid's planes, in cells.
using Place = std::array<double, 2>;

// In a narrow gap the pressure comes to its steady state by a few per cent of what is
// missing in a step, of whatever length: some two hundred steps.
constexpr int kMostSteps = 500;
constexpr double kSettledForce = 1e-4;  // change in a step, relative

/// Force against `against` over 6 pi mu a U on the first body, once the liquid has
/// followed.
inline double settled_force(TransientFlow& flow, const Scene& scene,
                            const std::vector<FlowBody>& bodies, const Vec3& against) {
  const double stokes =
      6.0 * kPi * scene.fluid.viscosity * kApproachRadius * norm(bodies[0].velocity);
  double force = 0.0;
  for (int n = 0; n < kMostSteps; ++n) {
    const double before = force;
    force = dot(flow.step(1e-4, bodies)[0].force, against) / stokes;
    if (std::abs(force - before) < kSettledForce * force) {
      break;
    }
  }
  return force;
}

/// A closed box of so many radii, all walls.
inline Scene closed_cube(int radii) {
  constexpr FaceCondition kWall = FaceCondition::wall;
  const double size = radii * kApproachRadius;
  Scene scene;
  scene.geometry.box = {{size, size, size}, {kWall, kWall, kWall, kWall, kWall, kWall}};
  return scene;
}

/// So many cells per diameter at bodies and grains, the base cell halved `levels` times.
inline TransientFlowOptions cube_cells(int radii, int cells_per_diameter,
                                       int levels = 2) {
  const int base = radii * cells_per_diameter / (2 << levels);
  TransientFlowOptions options;
  options.cells = {base, base, base};
  options.refinement = levels;
  options.wall_refinement = levels;
  return options;
}

/// Force over 6 pi mu a U on a sphere that is moved towards a wall on the grid, in a
/// closed box of eight radii, at the gap of `gap` cells; 10 or 16 cells per diameter.
inline double resolved_approach(int cells_per_diameter, double gap, const Place& place) {
  const double a = kApproachRadius;
  const double h = 2.0 * a / cells_per_diameter;
  const Scene scene = closed_cube(8);
  TransientFlow flow(scene, cube_cells(8, cells_per_diameter));
  FlowBody body;
  body.sphere = {{4.0 * a + place[0] * h, 4.0 * a + place[1] * h, a + gap * h}, a};
  body.velocity = {0.0, 0.0, -1e-5};
  return settled_force(flow, scene, {body}, {0.0, 0.0, 1.0});
}

/// What the walls beside and above add: what the force at a gap so wide that the grid
/// sees all of it is more than that of one wall.
inline double far_walls(int cells_per_diameter, const Place& place) {
  constexpr double kWide = 5.0;  // cells
  return resolved_approach(cells_per_diameter, kWide, place) -
         wall_resistance(kWide * 2.0 / cells_per_diameter).f_n;
}

/// The same where the sphere meets another one: a colloid that comes towards it as fast,
/// or a grain of twice its radius that is held.  `along`: from the other to the sphere.
enum class Other { colloid, grain };

inline double ratio_of(Other other) {
  return other == Other::grain ? 2.0 : 1.0;
}

/// `height`: of the middle of the box, as `place`.
inline double resolved_meeting(Other other, int cells_per_diameter, double gap,
                               const Place& place, Vec3 along, double height = 0.31) {
  constexpr int kRadii = 12;
  const double a = kApproachRadius;
  const double h = 2.0 * a / cells_per_diameter;
  along = (1.0 / norm(along)) * along;
  Scene scene = closed_cube(kRadii);
  const Vec3 middle{(0.5 * kRadii) * a + place[0] * h, (0.5 * kRadii) * a + place[1] * h,
                    (0.5 * kRadii) * a + height * h};
  const double b = ratio_of(other) * a;
  const Vec3 here = middle + (b + 0.5 * gap * h) * along;  // the gap is near the middle
  const Vec3 there = here - (a + b + gap * h) * along;
  std::vector<FlowBody> bodies(1);
  bodies[0].sphere = {here, a};
  bodies[0].velocity = -1e-5 * along;
  if (other == Other::grain) {
    scene.geometry.spheres.push_back({there, b});
  } else {
    bodies.emplace_back();
    bodies[1].sphere = {there, a};
    bodies[1].velocity = 1e-5 * along;
  }
  TransientFlow flow(scene, cube_cells(kRadii, cells_per_diameter));
  return settled_force(flow, scene, bodies, along);
}

/// Jeffrey & Onishi (1984): the force on the sphere over 6 pi mu a U.
inline double exact_meeting(Other other, double gap_over_radius) {
  const double ratio = ratio_of(other);
  static const TwoSphereResistance equal(1.0);
  static const TwoSphereResistance at_grain(2.0);
  const PairResistance r = (other == Other::grain ? at_grain : equal)
                               .at(2.0 * gap_over_radius / (1.0 + ratio));
  return other == Other::grain ? r.xa11 : r.xa11 - r.xa12;
}

inline double far_walls(Other other, int cells_per_diameter, const Place& place,
                        const Vec3& along) {
  constexpr double kWide = 5.0;  // cells
  return resolved_meeting(other, cells_per_diameter, kWide, place, along) -
         exact_meeting(other, kWide * 2.0 / cells_per_diameter);
}

/// What (T-D5) adds: over 6 pi mu a U.
inline double sub_grid_meeting(Other other, int cells_per_diameter, double gap) {
  const double a = kApproachRadius;
  const double cell = 2.0 * a / cells_per_diameter;
  const double b = ratio_of(other) * a;
  const double closing = other == Other::grain ? 1.0 : 2.0;  // over U
  return closing * lubrication_resistance(1.0, a * b / (a + b), gap * cell, cell, 1e-12) /
         (6.0 * kPi * a);
}

}  // namespace colloid
