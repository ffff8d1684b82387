#include "particles/contact_rules.h"

#include <algorithm>
#include <limits>

namespace colloid {

bool is_surface(const Box& box, const SurfaceId& id) {
  return id.kind != SurfaceId::Kind::face || box.face(id.index) == FaceCondition::wall;
}

double contact_gap(const ContactRules& rules, const Box& box, const SurfaceId& id) {
  switch (id.kind) {
    case SurfaceId::Kind::grain:
      return rules.grain_gap;
    case SurfaceId::Kind::colloid:
      return rules.colloid_gap;
    default:
      return is_surface(box, id) ? rules.wall_gap : 0.0;
  }
}

double contact_tolerance(double gap, double radius) {
  return std::max(kContactTolerance * gap, kLeastTolerance * radius);
}

bool attaches(const ContactRules& rules, const Box& box, const SurfaceId& id) {
  switch (id.kind) {
    case SurfaceId::Kind::grain:
      return rules.grains_attach;
    case SurfaceId::Kind::colloid:
      return rules.colloids_attach;
    default:
      return rules.walls_attach && is_surface(box, id);
  }
}

double attaching_push(const ContactRules& rules, const Box& box, const SurfaceId& id) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  switch (id.kind) {
    case SurfaceId::Kind::grain:
      return rules.grain_repulsion;
    case SurfaceId::Kind::colloid:
      return kNever;
    default:
      return is_surface(box, id) ? rules.wall_repulsion : kNever;
  }
}

}  // namespace colloid
