#include "scene/solid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace colloid {

namespace {

constexpr int kVolumeSamples = 48;  // per axis
constexpr int kFaceSamples = 192;   // per axis

/// `distance` reduced to that of the nearest image along periodic axes.
Vec3 nearest_image(const Box& box, Vec3 distance) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.periodic(axis)) {
      distance[axis] -= box.size[axis] * std::round(distance[axis] / box.size[axis]);
    }
  }
  return distance;
}

/// Whether the point is in no ball.  `last` is the ball that held the point before: asked
/// first, it answers for most points where all is solid.
bool is_void(const Box& box, const std::vector<Sphere>& balls, const Vec3& point,
             std::size_t& last) {
  const auto holds = [&](const Sphere& ball) {
    const Vec3 distance = nearest_image(box, point - ball.center);
    return dot(distance, distance) < ball.radius * ball.radius;
  };
  if (last < balls.size() && holds(balls[last])) {
    return false;
  }
  const auto found = std::find_if(balls.begin(), balls.end(), holds);
  last = static_cast<std::size_t>(found - balls.begin());
  return found == balls.end();
}

/// How many of the centres of counts[0] x counts[1] x counts[2] equal parts of the box,
/// an axis with the count 0 at the coordinate `fixed`, are void; no more than `enough`.
long count_void(const Box& box, const std::vector<Sphere>& balls,
                const std::array<int, 3>& counts, double fixed, long enough) {
  const auto coordinate = [&](std::size_t axis, int index) {
    return counts[axis] == 0
               ? fixed
               : box.size[static_cast<int>(axis)] * (index + 0.5) / counts[axis];
  };
  std::size_t last = 0;
  long found = 0;
  for (int k = 0; k < std::max(counts[2], 1); ++k) {
    for (int j = 0; j < std::max(counts[1], 1); ++j) {
      for (int i = 0; i < std::max(counts[0], 1); ++i) {
        const Vec3 point{coordinate(0, i), coordinate(1, j), coordinate(2, k)};
        found += is_void(box, balls, point, last) ? 1 : 0;
        if (found == enough) {
          return found;
        }
      }
    }
  }
  return found;
}

constexpr std::array<int, 3> kVolumeCounts{kVolumeSamples, kVolumeSamples,
                                           kVolumeSamples};

}  // namespace

double surface_gap(const Box& box, const Sphere& a, const Sphere& b) {
  return norm(nearest_image(box, a.center - b.center)) - a.radius - b.radius;
}

double room_at_face(const Box& box, const Sphere& ball, int face) {
  const int axis = axis_of(face);
  const double distance =
      is_upper(face) ? box.size[axis] - ball.center[axis] : ball.center[axis];
  return box.periodic(axis) ? distance : distance - ball.radius;
}

bool reaches_into(const Box& box, const Sphere& ball) {
  Vec3 outside;  // from the nearest point of the box to the centre
  for (int axis = 0; axis < 3; ++axis) {
    const double x = ball.center[axis];
    outside[axis] = x - std::clamp(x, 0.0, box.size[axis]);
  }
  return norm(outside) < ball.radius;
}

bool has_void(const Box& box, const std::vector<Sphere>& balls) {
  return count_void(box, balls, kVolumeCounts, 0.0, 1) > 0;
}

double void_fraction(const Box& box, const std::vector<Sphere>& balls) {
  constexpr long kAll = 1L * kVolumeSamples * kVolumeSamples * kVolumeSamples;
  return static_cast<double>(count_void(box, balls, kVolumeCounts, 0.0, kAll)) /
         static_cast<double>(kAll);
}

bool has_void_on_face(const Box& box, const std::vector<Sphere>& balls, int face) {
  std::array<int, 3> counts{kFaceSamples, kFaceSamples, kFaceSamples};
  const int axis = axis_of(face);
  counts[static_cast<std::size_t>(axis)] = 0;
  return count_void(box, balls, counts, is_upper(face) ? box.size[axis] : 0.0, 1) > 0;
}

}  // namespace colloid
