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
/// into the liquid.  From a table (tables/two_planes.py), within 1 % of the flow of each
/// plane alone where the normals are 30 degrees apart or more.
SentBackByBoth sent_back_by_both(const Vector3& a, double to_a, const Vector3& b,
                                 double to_b);

}  // namespace colloid
