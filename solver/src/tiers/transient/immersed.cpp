#include "tiers/transient/immersed.h"

#include <algorithm>
#include <cmath>

#include "particles/surfaces.h"

namespace colloid {

namespace {

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

}  // namespace

std::vector<ImmersedEntry> immerse(const OctreeLevels& levels, const OctreeMesh& mesh,
                                   const std::vector<Sphere>& bodies, double viscosity,
                                   double rigidity) {
  std::vector<ImmersedEntry> entries;
  const Vec3 ratio{1.0, levels.spacing(1) / levels.spacing(0),
                   levels.spacing(2) / levels.spacing(0)};
  const double longest = std::max({ratio.x, ratio.y, ratio.z});
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double r = bodies[b].radius;
    for (std::size_t cell = 0; cell < mesh.centres.size(); ++cell) {
      const Vec3 arm = shortest(levels.box, mesh.centres[cell], bodies[b].center);
      const double size = mesh.size[cell];
      const double reach = r + longest * size;
      const double distance2 = dot(arm, arm);
      if (distance2 >= reach * reach) {
        continue;
      }
      ImmersedEntry entry{static_cast<int>(cell), static_cast<int>(b), 0.0,
                          distance2 < r * r, arm};
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

}  // namespace colloid
