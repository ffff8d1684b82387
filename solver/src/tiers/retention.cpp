#include "tiers/retention.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/constants.h"
#include "scene/names.h"

namespace colloid {

namespace {

constexpr double kNearby = 0.01;  // over the radius: surfaces that hold by geometry
constexpr double kHeld = 1e-3;    // speed left, over that of the free sphere

// A fixed surface that a member touches.
struct Held {
  std::size_t member;
  NearSurface surface;
};

bool touches(const RetentionContext& context, const NearSurface& surface) {
  const Box& box = context.surfaces.box();
  const double gap = contact_gap(context.rules, box, surface.id);
  return is_surface(box, surface.id) &&
         surface.distance - context.radius <=
             gap + 2.0 * contact_tolerance(gap, context.radius);
}

std::vector<Held> fixed_contacts(const RetentionContext& context, const RigidBody& body) {
  std::vector<Held> contacts;
  std::vector<NearSurface> near;
  for (std::size_t m = 0; m < body.size(); ++m) {
    context.surfaces.near(body.position(m), near);
    for (const NearSurface& surface : near) {
      if (body.bonded_to(m, surface.id) || touches(context, surface)) {
        contacts.push_back({m, surface});
      }
    }
  }
  return contacts;
}

std::string name_of(const SurfaceId& id) {
  switch (id.kind) {
    case SurfaceId::Kind::grain:
      return fmt::format("grain {}", id.index);
    case SurfaceId::Kind::colloid:
      return fmt::format("colloid {}", id.index);
    default:
      return fmt::format("wall {}", face_name(id.index));
  }
}

double pull_off_of(const RetentionContext& context, const SurfaceId& id) {
  switch (id.kind) {
    case SurfaceId::Kind::grain:
      return context.grain_pull_off;
    case SurfaceId::Kind::colloid:
      return context.colloid_pull_off;
    default:
      return context.wall_pull_off;
  }
}

// Pull on each contact when together they balance `held`, forces of least norm.
std::vector<double> pulls(const RetentionContext& context, const RigidBody& body,
                          const std::vector<Held>& contacts, const BodyWrench& held) {
  if (contacts.empty()) {
    return {};
  }
  std::vector<Vector3> points;
  points.reserve(contacts.size());
  for (const Held& contact : contacts) {
    const double gap = contact.surface.distance - context.radius;
    points.push_back(eigen(body.arms[contact.member] -
                           contact.surface.normal * (context.radius + 0.5 * gap)) /
                     context.radius);
  }
  Vector6 load;
  load << -eigen(held.force), -eigen(held.torque) / context.radius;
  const std::vector<Vector3> forces = contact_loads(points, load);
  std::vector<double> out;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    out.push_back(std::max(0.0, -forces[i].dot(eigen(contacts[i].surface.normal))));
  }
  return out;
}

// Elevation of an attachment above the throat plane, seen from the grain's centre.
double elevation(const Vec3& normal, const Vec3& upstream) {
  return std::asin(std::clamp(dot(normal, upstream), -1.0, 1.0)) * 180.0 / kPi;
}

void judge(const RetentionContext& context, const RigidBody& body, std::size_t member,
           const std::vector<Held>& contacts, const BodyWrench& held,
           RetainedColloid& colloid) {
  bool grain = false;
  bool deposit = false;
  bool wall = false;
  for (const Held& contact : contacts) {
    if (contact.member != member) {
      continue;
    }
    const SurfaceId& id = contact.surface.id;
    colloid.partners.push_back(name_of(id));
    if (id.kind == SurfaceId::Kind::grain && !grain) {
      grain = true;
      colloid.alpha_deg = elevation(contact.surface.normal, context.upstream);
    }
    deposit = deposit || id.kind == SurfaceId::Kind::colloid;
    wall = wall || id.kind == SurfaceId::Kind::face;
  }
  for (std::size_t m = 0; m < body.size(); ++m) {
    const double r = norm(body.arms[m] - body.arms[member]);
    const double gap = context.rules.colloid_gap;
    if (m != member &&
        r <= 2.0 * context.radius + gap + 2.0 * contact_tolerance(gap, context.radius)) {
      colloid.partners.push_back(fmt::format("colloid {}", body.members[m].id));
      deposit = true;
    }
  }
  colloid.layer = grain              ? Layer::first
                  : wall && !deposit ? Layer::wall
                                     : Layer::multilayer;
  colloid.mechanism = grain              ? Mechanism::attachment_to_grain
                      : wall && !deposit ? Mechanism::attachment_to_wall
                                         : Mechanism::attachment_to_deposit;
  if (body.size() == 1 && held_by_geometry(context, colloid.position, held.force)) {
    colloid.mechanism = Mechanism::straining;
  }
}

}  // namespace

bool held_by_geometry(const RetentionContext& context, const Vec3& x, const Vec3& force) {
  std::vector<NearSurface> near;
  context.surfaces.near(x, near);
  std::vector<ContactRow> rows;
  for (const NearSurface& surface : near) {
    if (surface.id.kind != SurfaceId::Kind::colloid &&
        is_surface(context.surfaces.box(), surface.id) &&
        surface.distance - context.radius <= kNearby * context.radius) {
      ContactRow row;
      row.first = 0;
      row.row_first << eigen(surface.normal), Vector3::Zero();
      rows.push_back(row);
    }
  }
  if (rows.size() < 2) {
    return false;
  }
  BodySystem sphere;
  sphere.resistance = Matrix6::Identity();
  sphere.drive << eigen(force), Vector3::Zero();
  const BodyMotions motion = solve_motion({sphere}, {}, rows);
  return motion.motion.front().head<3>().norm() <= kHeld * norm(force);
}

std::vector<RetainedColloid> describe_retention(const RetentionContext& context,
                                                const RigidBody& body, std::size_t first,
                                                const BodyWrench& held) {
  const std::vector<Held> contacts = fixed_contacts(context, body);
  const std::vector<double> load = pulls(context, body, contacts, held);
  std::vector<std::size_t> order{first};
  for (std::size_t m = 0; m < body.size(); ++m) {
    if (m != first) {
      order.push_back(m);
    }
  }
  std::vector<RetainedColloid> out;
  for (std::size_t m : order) {
    const MobileColloid& member = body.members[m];
    RetainedColloid colloid;
    colloid.colloid = member.id;
    colloid.contact_time = member.contact_time;
    colloid.position = wrapped(context.surfaces.box(), body.position(m));
    colloid.injection_position = member.injection_position;
    colloid.injection_time = member.injection_time;
    judge(context, body, m, contacts, held, colloid);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (contacts[i].member == m) {
        colloid.bond_load = std::isnan(colloid.bond_load)
                                ? load[i]
                                : std::max(colloid.bond_load, load[i]);
        colloid.bond_overloaded = colloid.bond_overloaded ||
                                  load[i] > pull_off_of(context, contacts[i].surface.id);
      }
    }
    out.push_back(colloid);
  }
  return out;
}

}  // namespace colloid
