#include "packings.h"

#include <algorithm>
#include <cmath>

namespace colloid {

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

Box flow_box(const Vec3& size, FaceCondition sides) {
  return {size,
          {sides, sides, sides, sides, FaceCondition::outlet, FaceCondition::inlet}};
}

Box periodic_box(const Vec3& size) {
  Box box{size, {}};
  box.faces.fill(FaceCondition::periodic);
  return box;
}

Packing empty_throat() {
  const double d = kCollector;
  Packing throat{flow_box({d, d, 1.5 * d}, FaceCondition::wall), {}};
  for (int i = 0; i < 4; ++i) {
    throat.spheres.push_back({{(i % 2) * d, (i / 2) * d, 0.5 * d}, 0.5 * d});
  }
  return throat;
}

Packing clogging_throat(int colloids, std::uint64_t seed, double diameter) {
  Packing throat = empty_throat();
  std::mt19937_64 random(seed);
  const double a = 0.5 * diameter;
  const double width = throat.box.size.x - diameter;
  int left = 100 * colloids;
  while (static_cast<int>(throat.spheres.size()) < 4 + colloids && left-- > 0) {
    Vec3 place{a + width * uniform(random), a + width * uniform(random), -1.0};
    for (const Sphere& other : throat.spheres) {
      const double reach = other.radius + a;
      const double aside = std::hypot(place.x - other.center.x, place.y - other.center.y);
      if (aside < reach) {
        place.z =
            std::max(place.z, other.center.z + std::sqrt(reach * reach - aside * aside));
      }
    }
    if (place.z > a && place.z < throat.box.size.z - a) {
      throat.spheres.push_back({place, a});
    }
  }
  return throat;
}

std::vector<Sphere> random_cluster(const Vec3& size, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Sphere> spheres;
  const double edge = std::min({size.x, size.y, size.z});
  const double typical = 0.55 * edge / std::cbrt(static_cast<double>(count));
  for (int i = 0; i < count; ++i) {
    Sphere sphere;
    sphere.radius = typical * (0.4 + 0.9 * uniform(random));
    for (int axis = 0; axis < 3; ++axis) {
      sphere.center[axis] = size[axis] * (1.2 * uniform(random) - 0.1);
    }
    const double kind = uniform(random);
    if (kind < 0.3 && i > 0) {
      const auto other = spheres[static_cast<std::size_t>(random() % spheres.size())];
      const Vec3 apart = sphere.center - other.center;
      const double reach = sphere.radius + other.radius;
      sphere.center = other.center + apart * (reach / norm(apart));
    } else if (kind < 0.4) {
      const auto axis = static_cast<int>(random() % 3);
      sphere.center[axis] = sphere.radius;
    }
    spheres.push_back(sphere);
  }
  return spheres;
}

Packing permuted(const Packing& packing) {
  Packing other;
  const auto turn = [](const Vec3& v) { return Vec3{v.z, v.x, v.y}; };
  other.box.size = turn(packing.box.size);
  for (std::size_t face = 0; face < 6; ++face) {
    other.box.faces[(face + 2) % 6] = packing.box.faces[face];
  }
  for (const Sphere& sphere : packing.spheres) {
    other.spheres.push_back({turn(sphere.center), sphere.radius});
  }
  return other;
}

}  // namespace colloid
