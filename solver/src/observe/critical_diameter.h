// The diameter of the largest sphere that can pass through a packing.
//
// l_c is twice the largest clearance (distance to the nearest surface) that a path from
// inlet to outlet can keep everywhere: a max-min path.  Surfaces are spheres and planes,
// so the clearance is exact, and l_c is bracketed from both sides instead of being read
// from voxels:
//
//   above  The box is cut into cells; each has an upper bound of the clearance in it.  No
//          path beats the widest route through the cells (widest_route.h).
//   below  A polygon is threaded through that route; its clearance is exact (thread.h).
//
// Cells where the polygon stays below the middle of the bracket are split, until the
// bracket is as narrow as asked.  Only cells on the widest route are ever split.  The
// bounds are of second order in the cell (max_min.h), so that a bracket of 1e-9 needs
// cells of 3e-5 at the bottleneck, some fifteen halvings, and degenerate bottlenecks (a
// ridge between two walls) cost no more than isolated ones.
//
// Alternatives: (1) voxels and their percolation: an error of a voxel's diagonal, and a
// cost that grows with its third power.  (2) The graph of all points where three surfaces
// are equally near and enclose the point, joined by ascending paths: exact without a
// search, but complete only in general position, and the reference throat is not: four
// grains in a square, flat ridges between walls, symmetric pores.  (3) Regular
// triangulation and alpha shapes for a given diameter, with bisection: needs CGAL, and
// walls by images.  (4) Newton's method for the bottleneck after a coarse bracket: the
// second-order bounds make it needless.
#pragma once

#include <vector>

#include "core/box.h"
#include "observe/surface.h"

namespace colloid {

struct CriticalDiameter {
  double value = 0.0;    ///< l_c [m]: a sphere of this diameter can follow `path`
  double error = 0.0;    ///< no sphere larger than value + error can pass [m]
  bool blocked = false;  ///< value is 0: the widest path is at most the tolerance wide
  Vec3 bottleneck;       ///< the narrowest point of the path [m]; not set if blocked
  std::vector<SurfaceName> surfaces;  ///< nearest to the bottleneck, equally near
  std::vector<Vec3> path;  ///< corners [m]; periods are counted on: may leave the box
  int cells = 0;           ///< made by the search: its cost
};

struct CriticalDiameterOptions {
  /// Wanted `error`, and the width below which the packing counts as blocked, so that
  /// touching surfaces are closed whatever the rounding.  Relative to the smallest
  /// sphere's diameter, or without spheres to the shortest edge of the box.
  double tolerance = 1e-9;
  /// Of the flow, where the box has no inlet or no outlet: around the period of this
  /// axis, or from its one face to the other (which are then no surfaces, even if they
  /// are walls).
  int flow_axis = 2;
  /// The search ends with a larger `error` rather than make more cells.
  int most_cells = 2'000'000;
  /// Result for the same box and a part of the same spheres in the same order, or null.
  /// Spheres only narrow a packing: if the old path is still clear it is the answer, and
  /// otherwise the old value bounds the new one.
  const CriticalDiameter* before = nullptr;
};

/// Spheres may overlap, touch, and have their centres anywhere; through periodic faces
/// they act by their images.  Infinite if there is no surface at all.
CriticalDiameter critical_diameter(const Box& box, const std::vector<Sphere>& spheres,
                                   const CriticalDiameterOptions& options = {});

}  // namespace colloid
