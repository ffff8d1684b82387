// How surfaces shield each other from a sphere that several of them hinder.
//
// Close to one surface, the motion of the sphere is hardly felt at another one farther
// off, so their hindrances do not add up, nor do the drifts that the flow's strain gives
// to the sphere beside each of them.  At the level of a point force and a stresslet, both
// follow from the flow that every two surfaces together send back (two_planes.h).  MODEL
// (P4a), (P4b)
#pragma once

#include <vector>

#include "particles/small_matrix.h"

namespace colloid {

/// A plane, or a sphere so wide that its tangent plane stands for it.  What it does
/// alone:
struct WideSurface {
  Vector3 normal;       ///< into the liquid
  double height = 0.0;  ///< of the colloid's centre, over its radius
  double along = 1.0;   ///< resistance to motion along the normal
  double across = 1.0;  ///< and across it
  /// Velocity of a sphere free of force and held from turning, less that of the flow,
  /// over the strain along the normal and across it, times its radius.
  double drift_along = 0.0;
  double drift_across = 0.0;
  /// Strain along the normal, times the radius, over the velocity along it, of the flow
  /// whose drive is the surface's own.
  double strain_by_velocity = 0.0;
  double excess_coefficient = 0.0;  ///< force over 6 pi mu a^2 by strain beyond that
  double weight = 1.0;              ///< of the drifts; `along` and `across` have it
};

/// What surfaces do together, less the sum of what each does alone; over 6 pi mu a.
struct Shielding {
  Matrix3 resistance = Matrix3::Zero();  ///< to motion of the colloid's centre
  Vector3 drive = Vector3::Zero();       ///< of the ambient strain [m/s]
};

/// In a corner of two walls, 1.6 radii or more from both, the resistance is then right
/// within 2.5 % (the sum: 2 to 11 % too high).
///
/// `strain`: ambient, times the radius [m/s]; `velocity` [m/s].  Of a single surface: no
/// resistance, and what the strain drives beyond that of the surface's own flow.
Shielding shielding(const std::vector<WideSurface>& surfaces, const Matrix3& strain,
                    const Vector3& velocity);

}  // namespace colloid
