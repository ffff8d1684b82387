// How surfaces shield each other from a sphere that several of them hinder.
//
// Close to one surface, the motion of the sphere is hardly felt at another one farther
// off, so their hindrances do not add up.  At the level of point forces a second surface
// B sends back the flow of the sphere's image behind it; beside a first one, A, that
// image is a point force beside a no-slip plane (Blake 1971), not one in the bulk.  MODEL
// (P4)
#pragma once

#include <vector>

#include "particles/small_matrix.h"

namespace colloid {

/// A plane, or a sphere so wide that its tangent plane stands for it.
struct WideSurface {
  Vector3 normal;       ///< into the liquid
  double height = 0.0;  ///< of the colloid's centre, over its radius
  double along = 1.0;   ///< resistance to motion along the normal, of this one alone
  double across = 1.0;  ///< and across it
};

/// What to add to the sum of the resistances of each surface alone, to motion of the
/// colloid's centre; over 6 pi mu a: negative or zero, zero for a single surface.  In a
/// corner of two walls the resistance is then right within 5 % if one is 2.5 times as far
/// as the other (the sum: up to 11 % too high), and up to 13 % too low at equal distances
/// (the sum: 2 to 8 % too high).
Matrix3 shielding(const std::vector<WideSurface>& surfaces);

/// Velocity at x by a unit force at y beside the no-slip plane through the origin, normal
/// n, over 1/(8 pi mu length): Blake (1971), Proc. Camb. Phil. Soc. 70, 303.  Zero if y
/// is not on the liquid's side.
Matrix3 velocity_by_force_at_plane(const Vector3& x, const Vector3& y, const Vector3& n);

}  // namespace colloid
