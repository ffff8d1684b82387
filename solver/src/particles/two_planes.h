// What two planes together send back to a point force between them.
#pragma once

#include <array>

#include "particles/small_matrix.h"

namespace colloid {

/// Of the flow that planes A and B send back to a unit force, what neither would send
/// alone, at the force itself; over 1/(8 pi mu).
struct SentBackByBoth {
  Matrix3 flow;                   ///< column j: by a force along j
  Matrix3 laplacian;              ///< of it, in the place where it is seen; symmetrized
  std::array<Matrix3, 3> strain;  ///< by a force along j
};

/// Plane A with the normal `a` at the distance `to_a` from the force, B likewise; normals
/// into the liquid.  From a table (tables/two_planes.py): exchanging the planes changes
/// it by 0.001 at 60 to 150 degrees between the normals, up to 0.06 below 45 and 0.02
/// above, of entries of order 1.
SentBackByBoth sent_back_by_both(const Vector3& a, double to_a, const Vector3& b,
                                 double to_b);

}  // namespace colloid
