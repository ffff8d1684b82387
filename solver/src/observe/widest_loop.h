// The widest closed route around a period of the box.
#pragma once

#include "observe/widest_route.h"

namespace colloid {

/// Finds the closed route around the period of `axis` whose smallest upper bound is
/// largest; empty if none has a bound above `floor` [m].  It is known to be at most
/// `ceiling` [m] wide.
///
/// Cells join in order of falling upper bound.  A union-find keeps for each cell how many
/// periods lie between it and the root of its set; the first cell that joins two cells of
/// one set with a different count closes the loop.  It may wind more than once.
Route widest_loop(CellTree& tree, int axis, double floor, double ceiling);

}  // namespace colloid
