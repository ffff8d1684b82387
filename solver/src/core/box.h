// The domain: a box from the origin to `size`, a condition on each face, spheres in it.
#pragma once

#include <array>

#include "core/vec3.h"

namespace colloid {

/// What holds on one face of the box.
enum class FaceCondition { inlet, outlet, wall, periodic, symmetry };

/// Faces in the order of every array of six: x-, x+, y-, y+, z-, z+.
enum Face : int { x_minus, x_plus, y_minus, y_plus, z_minus, z_plus };
constexpr int kFaces = 6;

constexpr int axis_of(int face) {
  return face / 2;
}
constexpr bool is_upper(int face) {
  return face % 2 == 1;
}

struct Box {
  Vec3 size;                                ///< edge lengths [m]
  std::array<FaceCondition, kFaces> faces;  ///< periodic only in pairs

  bool periodic(int axis) const { return face(2 * axis) == FaceCondition::periodic; }
  FaceCondition face(int index) const { return faces[static_cast<std::size_t>(index)]; }
};

/// A ball with a no-slip surface: a grain, a retained colloid, a body.
struct Sphere {
  Vec3 center;          ///< [m]
  double radius = 0.0;  ///< [m]
};

}  // namespace colloid
