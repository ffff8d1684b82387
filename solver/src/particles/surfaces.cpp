#include "particles/surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace colloid {

namespace {

constexpr int kMostBuckets = 64;  // along an axis

bool holds_back(FaceCondition condition) {
  return condition == FaceCondition::wall || condition == FaceCondition::symmetry ||
         condition == FaceCondition::inlet;
}

}  // namespace

Vec3 shortest(const Box& box, const Vec3& a, const Vec3& b) {
  Vec3 e = a - b;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.periodic(axis)) {
      e[axis] -= box.size[axis] * std::round(e[axis] / box.size[axis]);
    }
  }
  return e;
}

Vec3 wrapped(const Box& box, const Vec3& x) {
  Vec3 inside = x;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.periodic(axis)) {
      const double size = box.size[axis];
      inside[axis] -= size * std::floor(inside[axis] / size);
      // Just below zero, or a rounded multiple: the sum is rounded too.
      if (inside[axis] >= size || inside[axis] < 0.0) {
        inside[axis] = 0.0;
      }
    }
  }
  return inside;
}

FixedSurfaces::FixedSurfaces(const Box& box, const std::vector<Sphere>& grains,
                             double reach)
    : box_(box), reach_(reach) {
  std::size_t total = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    buckets_[a] =
        std::clamp(static_cast<int>(2.0 * box.size[axis] / reach), 1, kMostBuckets);
    total *= static_cast<std::size_t>(buckets_[a]);
  }
  content_.resize(total);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    add({{SurfaceId::Kind::grain, static_cast<int>(i)}, grains[i]});
  }
}

void FixedSurfaces::add_colloid(int id, const Sphere& sphere) {
  add({{SurfaceId::Kind::colloid, id}, sphere});
}

void FixedSurfaces::add(const Entry& entry) {
  const int index = static_cast<int>(entries_.size());
  entries_.push_back(entry);
  Vec3 half;
  for (int axis = 0; axis < 3; ++axis) {
    half[axis] = 0.5 * box_.size[axis] / buckets_[static_cast<std::size_t>(axis)];
  }
  const double range = entry.sphere.radius + reach_ + norm(half);
  std::size_t at = 0;
  for (int k = 0; k < buckets_[2]; ++k) {
    for (int j = 0; j < buckets_[1]; ++j) {
      for (int i = 0; i < buckets_[0]; ++i, ++at) {
        const Vec3 middle{(2 * i + 1) * half.x, (2 * j + 1) * half.y,
                          (2 * k + 1) * half.z};
        if (norm(shortest(box_, middle, entry.sphere.center)) <= range) {
          content_[at].push_back(index);
        }
      }
    }
  }
}

int FixedSurfaces::bucket_of(double x, int axis) const {
  const int n = buckets_[static_cast<std::size_t>(axis)];
  double t = x / box_.size[axis];
  if (box_.periodic(axis)) {
    t -= std::floor(t);
  }
  return std::clamp(static_cast<int>(t * n), 0, n - 1);
}

void FixedSurfaces::near(const Vec3& x, std::vector<NearSurface>& out) const {
  out.clear();
  for (int face = 0; face < kFaces; ++face) {
    if (!holds_back(box_.face(face))) {
      continue;
    }
    const int axis = axis_of(face);
    NearSurface surface;
    surface.id = {SurfaceId::Kind::face, face};
    surface.distance = is_upper(face) ? box_.size[axis] - x[axis] : x[axis];
    surface.normal[axis] = is_upper(face) ? -1.0 : 1.0;
    surface.radius = std::numeric_limits<double>::infinity();
    out.push_back(surface);
  }
  const auto bucket = [&](int axis) {
    return static_cast<std::size_t>(bucket_of(x[axis], axis));
  };
  const auto count = [&](std::size_t axis) {
    return static_cast<std::size_t>(buckets_[axis]);
  };
  const std::size_t at = (bucket(2) * count(1) + bucket(1)) * count(0) + bucket(0);
  for (int index : content_[at]) {
    const Entry& entry = entries_[static_cast<std::size_t>(index)];
    const Vec3 e = shortest(box_, x, entry.sphere.center);
    const double r = norm(e);
    if (r > entry.sphere.radius + reach_) {
      continue;
    }
    // At the centre of a sphere every direction is a normal.
    const Vec3 normal = r > 0.0 ? e * (1.0 / r) : Vec3{0.0, 0.0, 1.0};
    out.push_back({entry.id, r - entry.sphere.radius, normal, entry.sphere.radius});
  }
}

NearSurface FixedSurfaces::seen_from(const Vec3& x, const SurfaceId& id) const {
  std::vector<NearSurface> surfaces;
  near(x, surfaces);
  const auto found = std::find_if(surfaces.begin(), surfaces.end(),
                                  [&](const NearSurface& s) { return s.id == id; });
  return found == surfaces.end() ? NearSurface{} : *found;
}

}  // namespace colloid
