#include "tiers/transient/immersed.h"

#include <algorithm>
#include <cmath>

#include "particles/surfaces.h"

namespace colloid {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Fraction of the step from `arm` (outside) along an axis at which a sphere of radius r
// around the origin begins; above one: not on this step.
double cut(const Vec3& arm, int axis, double step, double r) {
  const double b = arm[axis] * step;
  const double c = dot(arm, arm) - r * r;
  const double discriminant = b * b - step * step * c;
  if (discriminant <= 0.0 || b >= 0.0) {
    return 2.0;
  }
  // The smaller root of step^2 t^2 + 2 b t + c = 0, without cancellation.
  return c / (-b + std::sqrt(discriminant));
}

// In cells: nearer to another surface a body's cells stay liquid, and how strongly they
// then follow it, over nu/h^2.
constexpr double kOpen = 1.0;
constexpr double kOpenStrength = 2.0;

bool near_wall(const Box& box, const Vec3& x, const Vec3& size) {
  for (int face = 0; face < kFaces; ++face) {
    const int axis = axis_of(face);
    const double distance = is_upper(face) ? box.size[axis] - x[axis] : x[axis];
    if (box.face(face) == FaceCondition::wall && distance < kOpen * size[axis]) {
      return true;
    }
  }
  return false;
}

bool near_sphere(const Box& box, const Vec3& x, double size,
                 const std::vector<Sphere>& spheres) {
  return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
    return norm(shortest(box, x, sphere.center)) < sphere.radius + kOpen * size;
  });
}

}  // namespace

std::vector<ImmersedEntry> immerse(const OctreeLevels& levels, const OctreeMesh& mesh,
                                   const std::vector<Sphere>& bodies, double viscosity,
                                   double rigidity) {
  std::vector<ImmersedEntry> entries;
  const Vec3 ratio{1.0, levels.spacing(1) / levels.spacing(0),
                   levels.spacing(2) / levels.spacing(0)};
  const double longest = std::max({ratio.x, ratio.y, ratio.z});
  const double coarsest = longest * levels.spacing(0);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double r = bodies[b].radius;
    for (const int cell : cells_around(levels, mesh, bodies[b].center, r + coarsest)) {
      const Vec3 arm = shortest(levels.box, mesh.centres[at(cell)], bodies[b].center);
      const double size = mesh.size[at(cell)];
      const double reach = r + longest * size;
      const double distance2 = dot(arm, arm);
      if (distance2 >= reach * reach) {
        continue;
      }
      ImmersedEntry entry{cell, static_cast<int>(b), 0.0, distance2 < r * r, arm};
      if (entry.solid) {
        entry.strength = rigidity * viscosity / (size * size);
      } else {
        for (int axis = 0; axis < 3; ++axis) {
          const double h = size * ratio[axis];
          for (const double step : {-h, h}) {
            Vec3 beyond = arm;
            beyond[axis] += step;
            if (dot(beyond, beyond) < r * r) {
              const double theta = cut(arm, axis, step, r);
              entry.strength +=
                  viscosity / (h * h) * std::min(1.0 / theta - 1.0, rigidity);
            }
          }
        }
      }
      if (entry.strength > 0.0) {
        entries.push_back(entry);
      }
    }
  }
  return entries;
}

void open_narrow_gaps(const OctreeLevels& levels, const OctreeMesh& mesh, int body,
                      const std::vector<Sphere>& spheres, double viscosity,
                      std::vector<ImmersedEntry>& entries) {
  const Vec3 ratio{1.0, levels.spacing(1) / levels.spacing(0),
                   levels.spacing(2) / levels.spacing(0)};
  const Sphere& self = spheres[static_cast<std::size_t>(body)];
  std::vector<Sphere> neighbours;
  for (const Sphere& sphere : spheres) {
    const double gap = norm(shortest(levels.box, sphere.center, self.center)) -
                       sphere.radius - self.radius;
    if (&sphere != &self && gap < levels.spacing(0)) {
      neighbours.push_back(sphere);
    }
  }
  for (ImmersedEntry& entry : entries) {
    if (entry.body != body) {
      continue;
    }
    const Vec3& x = mesh.centres[static_cast<std::size_t>(entry.cell)];
    const double size = mesh.size[static_cast<std::size_t>(entry.cell)];
    const double open = kOpenStrength * viscosity / (size * size);
    if (entry.strength > open && (near_wall(levels.box, x, size * ratio) ||
                                  near_sphere(levels.box, x, size, neighbours))) {
      entry.strength = open;
      entry.solid = false;
    }
  }
}

}  // namespace colloid
