#include "observe/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace colloid {

double distance(const Surface& surface, const Vec3& point) {
  if (surface.is_plane()) {
    return surface.normal * (point[surface.axis] - surface.position);
  }
  return norm(point - surface.center) - surface.radius;
}

Vec3 direction(const Surface& surface, const Vec3& point) {
  Vec3 gradient;
  if (surface.is_plane()) {
    gradient[surface.axis] = surface.normal;
    return gradient;
  }
  gradient = point - surface.center;
  const double length = norm(gradient);
  return length > 0.0 ? gradient * (1.0 / length) : Vec3{};
}

double least_distance(const Surface& surface, const Extent& extent) {
  if (surface.is_plane()) {
    return std::min(distance(surface, extent.lo), distance(surface, extent.hi));
  }
  Vec3 gap;
  for (int axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max({extent.lo[axis] - surface.center[axis],
                          surface.center[axis] - extent.hi[axis], 0.0});
  }
  return norm(gap) - surface.radius;
}

double largest_distance(const Surface& surface, const Extent& extent) {
  if (surface.is_plane()) {
    return std::max(distance(surface, extent.lo), distance(surface, extent.hi));
  }
  Vec3 reach;
  for (int axis = 0; axis < 3; ++axis) {
    reach[axis] = std::max(surface.center[axis] - extent.lo[axis],
                           extent.hi[axis] - surface.center[axis]);
  }
  return norm(reach) - surface.radius;
}

SegmentDistance segment_distance(const Surface& surface, const Vec3& from,
                                 const Vec3& to) {
  double fraction = 0.0;
  if (surface.is_plane()) {
    fraction = distance(surface, to) < distance(surface, from) ? 1.0 : 0.0;
  } else {
    const Vec3 along = to - from;
    const double square = dot(along, along);
    if (square > 0.0) {
      fraction = std::clamp(dot(surface.center - from, along) / square, 0.0, 1.0);
    }
  }
  return {distance(surface, from + fraction * (to - from)), fraction};
}

Vec3 wrapped(const Box& box, Vec3 point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.periodic(axis)) {
      point[axis] -= box.size[axis] * std::floor(point[axis] / box.size[axis]);
    }
  }
  return point;
}

namespace {

// Of two equal spheres the first one stays.
bool is_inside_another(const std::vector<Sphere>& spheres, std::size_t index) {
  const Sphere& inner = spheres[index];
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double spare = spheres[i].radius - inner.radius;
    if (i == index || spare < 0.0) {
      continue;
    }
    const Vec3 offset = spheres[i].center - inner.center;
    const double square = dot(offset, offset);
    if (square < spare * spare ||
        (square == spare * spare && (spare > 0.0 || i < index))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Surface> surfaces_of(const Box& box, const std::vector<Sphere>& spheres,
                                 const std::vector<int>& open_faces) {
  std::vector<Surface> all;
  for (int face = 0; face < kFaces; ++face) {
    const bool open =
        std::find(open_faces.begin(), open_faces.end(), face) != open_faces.end();
    if (box.face(face) != FaceCondition::wall || open) {
      continue;
    }
    Surface wall;
    wall.name = {SurfaceName::Kind::wall, face};
    wall.axis = axis_of(face);
    wall.normal = is_upper(face) ? -1.0 : 1.0;
    wall.position = is_upper(face) ? box.size[wall.axis] : 0.0;
    all.push_back(wall);
  }
  std::array<int, 3> reach = {};
  for (int axis = 0; axis < 3; ++axis) {
    reach[static_cast<std::size_t>(axis)] = box.periodic(axis) ? 1 : 0;
  }
  for (std::size_t index = 0; index < spheres.size(); ++index) {
    if (is_inside_another(spheres, index)) {
      continue;
    }
    const Vec3 home = wrapped(box, spheres[index].center);
    for (int i = -reach[0]; i <= reach[0]; ++i) {
      for (int j = -reach[1]; j <= reach[1]; ++j) {
        for (int k = -reach[2]; k <= reach[2]; ++k) {
          Surface image;
          image.name = {SurfaceName::Kind::sphere, static_cast<int>(index)};
          image.center = home + Vec3{i * box.size.x, j * box.size.y, k * box.size.z};
          image.radius = spheres[index].radius;
          all.push_back(image);
        }
      }
    }
  }
  return all;
}

}  // namespace colloid
