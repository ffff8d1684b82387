#include <algorithm>
#include <limits>

#include "particles/integrator.h"

namespace colloid {

double distance_to_exit(const Box& box, const Vec3& x, double radius) {
  double least = std::numeric_limits<double>::infinity();
  for (int face = 0; face < kFaces; ++face) {
    if (box.face(face) == FaceCondition::outlet) {
      const int axis = axis_of(face);
      const double to_face = is_upper(face) ? box.size[axis] - x[axis] : x[axis];
      least = std::min(least, to_face - radius);
    }
  }
  return least;
}

std::vector<Touch> find_touches(const std::vector<RigidBody>& bodies,
                                const FixedSurfaces& surfaces, const ContactRules& rules,
                                double radius) {
  std::vector<Touch> touches;
  std::vector<NearSurface> near;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t m = 0; m < bodies[b].size(); ++m) {
      const Vec3 x = bodies[b].position(m);
      surfaces.near(x, near);
      for (const NearSurface& surface : near) {
        const double gap = surface.distance - radius;
        const double touching = contact_gap(rules, surfaces.box(), surface.id);
        if (gap <= touching + contact_tolerance(touching, radius) &&
            !bodies[b].bonded_to(m, surface.id)) {
          touches.push_back(
              {{static_cast<int>(b), static_cast<int>(m), surface.id, -1, 0}, gap});
        }
      }
      const double touching = rules.colloid_gap;
      const double reach = 2.0 * radius + touching + contact_tolerance(touching, radius);
      for (std::size_t other = b + 1; other < bodies.size(); ++other) {
        for (std::size_t om = 0; om < bodies[other].size(); ++om) {
          const double r = norm(shortest(surfaces.box(), x, bodies[other].position(om)));
          if (r <= reach) {
            touches.push_back({{static_cast<int>(b),
                                static_cast<int>(m),
                                {SurfaceId::Kind::colloid, bodies[other].members[om].id},
                                static_cast<int>(other),
                                static_cast<int>(om)},
                               r - 2.0 * radius});
          }
        }
      }
    }
  }
  return touches;
}

bool sticks(const Touch& touch, const ContactRules& rules, const Box& box) {
  if (touch.contact.other_body >= 0) {
    return rules.colloids_attach && rules.aggregates;
  }
  return attaches(rules, box, touch.contact.fixed);
}

}  // namespace colloid
