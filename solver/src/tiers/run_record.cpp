#include "tiers/run_record.h"

#include <cmath>
#include <utility>

namespace colloid {

namespace {

constexpr long kOutputs = 500;        // intervals of the series and trajectories
constexpr double kRestSpeed = 1e-3;   // of the inlet's speed
constexpr double kRestTravel = 0.01;  // of the radius

SeriesRow series_row(const RunState& state, const GrowingDeposit& deposit,
                     double permeability, int first_injected) {
  const Realisation& r = state.realisation;
  SeriesRow row;
  row.time = state.time;
  row.critical_diameter = deposit.critical().value;
  row.permeability = permeability;
  row.permeability_ratio = permeability / deposit.first_permeability();
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

// Retained colloids, then mobile ones.
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

}  // namespace

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double next_output_time(const RunState& state, double duration) {
  return duration * static_cast<double>(state.next_output) / kOutputs;
}

void record_output(RunState& state, const GrowingDeposit& deposit, double permeability,
                   int first_injected, double radius) {
  state.realisation.series.push_back(
      series_row(state, deposit, permeability, first_injected));
  state.realisation.frames.push_back(make_frame(state, radius));
}

void record_end(RunState& state, const Scene& scene, const GrowingDeposit& deposit,
                double permeability, int first_injected) {
  Realisation& r = state.realisation;
  r.duration = state.time;
  if (deposit.ends_run(r)) {
    r.ending = Ending::clogged;
  }
  if (r.series.empty() || r.series.back().time < state.time) {
    record_output(state, deposit, permeability, first_injected,
                  0.5 * scene.colloids->diameter);
  }
  const SeriesRow last = series_row(state, deposit, permeability, first_injected);
  r.counts = {last.injected, last.delayed,  last.mobile,
              last.bonded,   last.retained, last.traversed};
}

void inject_next(RunState& state, InjectionSequence& sequence, int first_injected,
                 const std::function<bool(int)>& inject) {
  const int index = state.next_injection++;
  const InjectedColloid& colloid = sequence.at(index);
  state.realisation.injections.push_back(
      {first_injected + index, colloid.volume, kNotYet, colloid.position});
  if (!inject(index)) {
    state.delayed.push_back(index);
    ++state.times_delayed;
  }
}

void inject_waiting(RunState& state, const std::function<bool(int)>& inject) {
  std::vector<int> waiting;
  std::swap(waiting, state.delayed);
  for (const int index : waiting) {
    if (!inject(index)) {
      state.delayed.push_back(index);
    }
  }
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

RestRule::RestRule(double inlet_speed, double radius)
    : limit_(kRestSpeed * inlet_speed), travel_(kRestTravel * radius) {}

bool RestRule::at_rest(RigidBody& body, bool held, double speed, double time) const {
  if (!held || speed > limit_) {
    body.slow_since = kNotYet;
  } else if (std::isnan(body.slow_since) || norm(body.centre - body.slow_at) > travel_) {
    body.slow_since = time;
    body.slow_at = body.centre;
  } else {
    return time - body.slow_since >= travel_ / limit_;
  }
  return false;
}

}  // namespace colloid
