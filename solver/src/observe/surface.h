// Surfaces that bound the liquid: spheres with their periodic images, and wall faces.
#pragma once

#include <vector>

#include "core/box.h"

namespace colloid {

/// Names a surface to the caller: a sphere by its place in the list, a wall by its face.
struct SurfaceName {
  enum class Kind { sphere, wall };
  Kind kind = Kind::sphere;
  int index = -1;  ///< in the list of spheres, or a Face
};
inline bool operator==(const SurfaceName& a, const SurfaceName& b) {
  return a.kind == b.kind && a.index == b.index;
}

/// One sphere (or one periodic image of it) or one plane.  Its signed distance is a
/// convex function of the point, with a gradient of length one: all bounds here rest on
/// that.
struct Surface {
  SurfaceName name;
  Vec3 center;            ///< of the sphere [m]
  double radius = 0.0;    ///< of the sphere [m]
  int axis = -1;          ///< of the plane's normal; -1: a sphere
  double normal = 1.0;    ///< of the plane, into the box: +1 or -1
  double position = 0.0;  ///< of the plane on its axis [m]

  bool is_plane() const { return axis >= 0; }
};

/// A box [lo, hi], possibly flat: a cell, a face, a gate between two cells.
struct Extent {
  Vec3 lo;  ///< [m]
  Vec3 hi;  ///< [m]

  Vec3 center() const { return 0.5 * (lo + hi); }
};

/// Signed distance from a point to the surface [m], negative inside a sphere.
double distance(const Surface& surface, const Vec3& point);
/// A subgradient of `distance` [-]; zero at the centre of a sphere.
Vec3 direction(const Surface& surface, const Vec3& point);
/// Smallest and largest distance over an extent [m]; exact.
double least_distance(const Surface& surface, const Extent& extent);
double largest_distance(const Surface& surface, const Extent& extent);

/// Where a segment comes nearest to the surface; exact.
struct SegmentDistance {
  double value = 0.0;     ///< [m]
  double fraction = 0.0;  ///< from the segment's start (0) to its end (1)
};
SegmentDistance segment_distance(const Surface& surface, const Vec3& from,
                                 const Vec3& to);

/// The point moved by whole periods into the box, on periodic axes.
Vec3 wrapped(const Box& box, Vec3 point);

/// All surfaces that can be the nearest one of a point in the box.  A sphere is moved
/// into the box along periodic axes and joined by its images one period away.  Spheres
/// that lie inside another one are left out.  `open` faces are no surfaces even where
/// they are walls.
std::vector<Surface> surfaces_of(const Box& box, const std::vector<Sphere>& spheres,
                                 const std::vector<int>& open_faces);

}  // namespace colloid
