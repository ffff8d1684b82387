#include "tiers/run_record.h"

namespace colloid {

SeriesRow make_series_row(const RunState& state, double critical_diameter,
                          double permeability, double first_permeability,
                          int first_injected) {
  const Realisation& r = state.realisation;
  SeriesRow row;
  row.time = state.time;
  row.critical_diameter = critical_diameter;
  row.permeability = permeability;
  row.permeability_ratio = permeability / first_permeability;
  row.injected = first_injected + state.next_injection;
  row.delayed = static_cast<long>(state.delayed.size());
  for (const RigidBody& body : state.bodies) {
    row.mobile += static_cast<long>(body.size());
    row.bonded += body.attached() ? static_cast<long>(body.size()) : 0;
  }
  row.retained = static_cast<long>(r.retained.size());
  for (const RetainedColloid& colloid : r.retained) {
    row.first_layer += colloid.layer == Layer::first ? 1 : 0;
    row.multilayer += colloid.layer == Layer::multilayer ? 1 : 0;
    row.wall_layer += colloid.layer == Layer::wall ? 1 : 0;
  }
  row.traversed = r.counts.traversed;
  return row;
}

Frame make_frame(const RunState& state, double radius) {
  Frame out;
  out.step = state.next_output;
  out.time = state.time;
  for (const RetainedColloid& colloid : state.realisation.retained) {
    out.colloids.push_back({static_cast<int>(colloid.colloid), colloid.position, Vec3{},
                            ColloidState::retained, 2.0 * radius});
  }
  for (const RigidBody& body : state.bodies) {
    for (std::size_t m = 0; m < body.size(); ++m) {
      out.colloids.push_back(
          {body.members[m].id, body.position(m), body.velocity_of(m),
           body.attached() ? ColloidState::bonded : ColloidState::mobile, 2.0 * radius});
    }
  }
  return out;
}

Counts final_counts(const SeriesRow& last) {
  return {last.injected, last.delayed,  last.mobile,
          last.bonded,   last.retained, last.traversed};
}

bool has_room(const RunState& state, const FixedSurfaces& surfaces, const Vec3& position,
              double distance) {
  for (const RigidBody& body : state.bodies) {
    for (std::size_t m = 0; m < body.size(); ++m) {
      if (norm(shortest(surfaces.box(), position, body.position(m))) < distance) {
        return false;
      }
    }
  }
  std::vector<NearSurface> near;
  surfaces.near(position, near);
  for (const NearSurface& surface : near) {
    if (surface.id.kind == SurfaceId::Kind::colloid &&
        surface.distance + surface.radius < distance) {
      return false;
    }
  }
  return true;
}

}  // namespace colloid
