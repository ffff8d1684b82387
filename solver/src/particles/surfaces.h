// What a mobile colloid can touch that does not move: grains, retained colloids, and the
// faces of the box that hold it back.
#pragma once

#include <vector>

#include "core/box.h"

namespace colloid {

struct SurfaceId {
  enum class Kind {
    grain,    ///< index: in the scene's list
    colloid,  ///< retained; index: its id
    face      ///< of the box; index: a Face
  };
  Kind kind = Kind::grain;
  int index = -1;
};
inline bool operator==(const SurfaceId& a, const SurfaceId& b) {
  return a.kind == b.kind && a.index == b.index;
}
inline bool operator<(const SurfaceId& a, const SurfaceId& b) {
  return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
}

/// A surface as seen from the centre of a colloid.
struct NearSurface {
  SurfaceId id;
  double distance = 0.0;  ///< from the surface to the colloid's centre [m]
  Vec3 normal;            ///< unit vector from the surface to the centre
  double radius = 0.0;    ///< of the sphere [m]; infinite for a face
};

/// The fixed surfaces around a point, found through buckets.  Spheres act through
/// periodic faces by their images.  Wall, symmetry and inlet faces hold colloids back;
/// they are returned whatever their distance.
class FixedSurfaces {
 public:
  /// Spheres are found within `reach` [m] of their surface.
  FixedSurfaces(const Box& box, const std::vector<Sphere>& grains, double reach);

  void add_colloid(int id, const Sphere& sphere);

  /// Clears `out` and fills it: faces first, then spheres in the order in which they
  /// came.
  void near(const Vec3& x, std::vector<NearSurface>& out) const;

  /// The surface `id`, which must be near; no normal (zero) if it is not.
  NearSurface seen_from(const Vec3& x, const SurfaceId& id) const;

  const Box& box() const { return box_; }
  double reach() const { return reach_; }

 private:
  struct Entry {
    SurfaceId id;
    Sphere sphere;
  };

  void add(const Entry& entry);
  int bucket_of(double x, int axis) const;

  Box box_;
  double reach_;
  std::array<int, 3> buckets_{};
  std::vector<Entry> entries_;
  std::vector<std::vector<int>> content_;  ///< per bucket: entries within reach of it
};

/// The shortest vector from b to a, through periodic faces where that is shorter.
Vec3 shortest(const Box& box, const Vec3& a, const Vec3& b);

/// The image of x in the box: 0 <= x < size along periodic axes, unchanged along others.
Vec3 wrapped(const Box& box, const Vec3& x);

}  // namespace colloid
