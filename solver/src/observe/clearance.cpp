#include "observe/clearance.h"

#include <cmath>
#include <limits>

namespace colloid {

Clearance clearance(const Box& box, const std::vector<Sphere>& spheres,
                    const Vec3& point) {
  Clearance result;
  result.distance = std::numeric_limits<double>::infinity();
  for (int face = 0; face < kFaces; ++face) {
    if (box.face(face) != FaceCondition::wall) {
      continue;
    }
    const int axis = axis_of(face);
    const double to_wall = is_upper(face) ? box.size[axis] - point[axis] : point[axis];
    if (to_wall < result.distance) {
      result = {to_wall, {SurfaceName::Kind::wall, face}};
    }
  }
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    Vec3 offset = point - spheres[i].center;
    for (int axis = 0; axis < 3; ++axis) {
      if (box.periodic(axis)) {
        offset[axis] -= box.size[axis] * std::round(offset[axis] / box.size[axis]);
      }
    }
    const double to_sphere = norm(offset) - spheres[i].radius;
    if (to_sphere < result.distance) {
      result = {to_sphere, {SurfaceName::Kind::sphere, static_cast<int>(i)}};
    }
  }
  return result;
}

}  // namespace colloid
