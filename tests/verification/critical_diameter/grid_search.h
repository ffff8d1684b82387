// The reference: l_c from clearances at the points of a dense grid, sharing no code with
// the solver.
#pragma once

#include "packings.h"

namespace colloid {

/// An interval that contains l_c [m].
struct Bracket {
  double low = 0.0;
  double high = 0.0;
};

/// Percolation on a grid of `per_edge` intervals along the shortest edge of the box.
///
/// The clearance is Lipschitz with constant one.  Let r be the largest clearance that a
/// walk over neighbouring grid points (spacing s) can keep.  The polygon of that walk
/// keeps r - s/2.  A path of clearance R passes the boxes around grid points, face to
/// face; each holds a point of the path, so its grid point keeps R - |(s_x, s_y, s_z)|/2.
/// Hence r - s/2 <= l_c/2 <= r + |(s_x, s_y, s_z)|/2.  The grid has points on the faces.
Bracket grid_critical_diameter(const Packing& packing, int per_edge);

}  // namespace colloid
