// What the transient flow alone resists with where a sphere slides or turns beside a
// surface, what (T-D5) adds, and the exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "approach_case.h"

namespace colloid {

enum class Beside { wall, grain, colloid };

/// Of a sphere beside a wall, n its normal, or a held grain of twice its radius: factors
/// of (R1), for sliding along t and turning about n x t.  Beside another colloid: that
/// one slides the other way, or turns the same way.
struct Sliding {
  double f_t = 0.0;  ///< force of sliding
  double t_t = 0.0;  ///< torque of sliding
  double f_r = 0.0;  ///< force of turning; t_t, by reciprocity
  double t_r = 0.0;  ///< torque of turning
};
inline Sliding operator+(const Sliding& a, const Sliding& b) {
  return {a.f_t + b.f_t, a.t_t + b.t_t, a.f_r + b.f_r, a.t_r + b.t_r};
}

constexpr double kTurning = 0.75;  // 6 pi mu a^3 over 8 pi mu a^3

/// Directions of a case.
struct Directions {
  Vec3 normal, along, about;
};
inline Directions directions(const Vec3& from_other) {
  Directions d;
  d.normal = (1.0 / norm(from_other)) * from_other;
  const Vec3 any = std::abs(d.normal.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  d.along = any - dot(any, d.normal) * d.normal;
  d.along = (1.0 / norm(d.along)) * d.along;
  d.about = cross(d.normal, d.along);
  return d;
}

/// Radii: so wide that the other walls of the box add less than 0.01 to f_t.
constexpr int kWideBox = 24;

/// The flow's, once the liquid has followed.
inline FlowResponse settled_response(TransientFlow& flow,
                                     const std::vector<FlowBody>& bodies, double stokes) {
  FlowResponse found;
  for (int n = 0; n < kMostSteps; ++n) {
    const FlowResponse before = found;
    found = flow.step(1e-4, bodies)[0];
    if (norm(found.force - before.force) +
            norm(found.torque - before.torque) / kApproachRadius <
        kSettledForce * stokes) {
      break;
    }
  }
  return found;
}

/// The flow alone, at the gap of `gap` cells; 10 or 16 cells per diameter.  `from_other`:
/// to the sphere; from a wall z.
inline Sliding resolved_sliding(Beside beside, int cells_per_diameter, double gap,
                                const Place& place, const Vec3& from_other) {
  const double a = kApproachRadius;
  const double h = 2.0 * a / cells_per_diameter;
  const double speed = 1e-5;
  const Directions d = directions(from_other);
  Scene scene = closed_cube(kWideBox);
  const double stokes = 6.0 * kPi * scene.fluid.viscosity * a * speed;
  const double middle = 0.5 * kWideBox * a;
  std::vector<FlowBody> bodies(1);
  bodies[0].sphere = {{middle + place[0] * h, middle + place[1] * h, a + gap * h}, a};
  if (beside != Beside::wall) {
    const double b = beside == Beside::grain ? 2.0 * a : a;
    bodies[0].sphere.center.z = middle + 0.31 * h;
    const Sphere other{bodies[0].sphere.center - (a + b + gap * h) * d.normal, b};
    if (beside == Beside::grain) {
      scene.geometry.spheres.push_back(other);
    } else {
      bodies.emplace_back();
      bodies[1].sphere = other;
    }
  }
  const auto answer = [&](const Vec3& velocity, const Vec3& spin) {
    bodies[0].velocity = velocity;
    bodies[0].spin = spin;
    if (beside == Beside::colloid) {
      bodies[1].velocity = -velocity;
      bodies[1].spin = spin;
    }
    TransientFlow flow(scene, cube_cells(kWideBox, cells_per_diameter, 3));
    return settled_response(flow, bodies, stokes);
  };
  const FlowResponse slides = answer(speed * d.along, {});
  const FlowResponse turns = answer({}, (speed / a) * d.about);
  const double torque = stokes * a / kTurning;
  return {-dot(slides.force, d.along) / stokes, dot(slides.torque, d.about) / torque,
          dot(turns.force, d.along) * kTurning / stokes,
          -dot(turns.torque, d.about) / torque};
}

/// What (T-D5) adds.
inline Sliding sub_grid_sliding(Beside beside, int cells_per_diameter, double gap,
                                const Vec3& from_other) {
  const double a = kApproachRadius;
  const double cell = 2.0 * a / cells_per_diameter;
  const double b = 2.0 * a;  // of a grain
  const Directions d = directions(from_other);
  const double mu = 1.0 / (6.0 * kPi * a);
  const GapResistance resistance(mu, a, {b}, cell, 1e-12);
  Matrix6 slides, turns;
  if (beside == Beside::colloid) {
    const Matrix12 both = resistance.between((2.0 * a + gap * cell) * d.normal);
    slides = both.topLeftCorner<6, 6>() - both.topRightCorner<6, 6>();
    turns = both.topLeftCorner<6, 6>() + both.topRightCorner<6, 6>();
  } else {
    NearSurface surface;
    surface.id.kind =
        beside == Beside::wall ? SurfaceId::Kind::face : SurfaceId::Kind::grain;
    surface.distance = a + gap * cell;
    surface.normal = d.normal;
    surface.radius = beside == Beside::wall ? HUGE_VAL : b;
    slides = turns = resistance.beside(surface);
  }
  const Vector3 t = eigen(d.along);
  const Vector3 w = eigen(d.about);
  return {t.dot(slides.topLeftCorner<3, 3>() * t),
          -kTurning * w.dot(slides.bottomLeftCorner<3, 3>() * t),
          -kTurning * t.dot(turns.topRightCorner<3, 3>() * w),
          kTurning * w.dot(turns.bottomRightCorner<3, 3>() * w)};
}

/// Goldman, Cox & Brenner (1967) at a wall, Jeffrey & Onishi (1984) otherwise.
inline Sliding exact_sliding(Beside beside, double gap_over_radius) {
  if (beside == Beside::wall) {
    const WallResistance w = wall_resistance(gap_over_radius);
    return {w.f_t, w.t_t, w.t_t, w.t_r};
  }
  static const TwoSphereResistance equal(1.0);
  static const TwoSphereResistance at_grain(2.0);
  if (beside == Beside::grain) {
    const PairResistance r = at_grain.at(2.0 * gap_over_radius / 3.0);
    return {r.ya11, -0.5 * r.yb11, -0.5 * r.yb11, r.yc11};
  }
  const PairResistance r = equal.at(gap_over_radius);
  return {r.ya11 - r.ya12, -0.5 * (r.yb11 - r.yb12), -0.5 * (r.yb11 + r.yb21),
          r.yc11 + r.yc12};
}

}  // namespace colloid
