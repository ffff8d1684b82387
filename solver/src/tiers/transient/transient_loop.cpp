#include "tiers/transient/transient_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "particles/hindrance.h"
#include "particles/integrator.h"
#include "tiers/flow_problem.h"
#include "tiers/retention.h"
#include "tiers/run_record.h"
#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

constexpr int kMostSettling = 400;
constexpr double kSettled = 3e-4;
constexpr double kSettlingStep = 0.1;  // over the viscous time of the narrowest passage
// Explicit coupling is stable below about this much of the relaxation time (Stokes drag
// with added mass and history); narrow gaps need less still.
constexpr double kExplicitLimit = 0.6;

double sphere_volume(double radius) {
  return 4.0 / 3.0 * kPi * radius * radius * radius;
}

TransientFlowOptions flow_options(const Scene& scene) {
  TransientFlowOptions options;
  options.cells = choose_cells(scene, {});
  options.refinement = scene.fidelity.refinement;
  options.wall_refinement = scene.fidelity.wall_refinement;
  options.outer_iterations = scene.fidelity.subiterations;
  return options;
}

// `cell`: edge of the flow's cells at colloids.
DemOptions dem_options(const Scene& scene, const SurfaceModel& contacts,
                       const Regime& regime, double cell) {
  const Colloids& colloids = *scene.colloids;
  DemOptions options(contacts);
  options.box = scene.geometry.box;
  options.radius = 0.5 * colloids.diameter;
  options.density = colloids.density;
  options.fluid_density = scene.fluid.density;
  options.viscosity = scene.fluid.viscosity;
  options.gravity = scene.gravity;
  options.colloid = {colloids.young_modulus, colloids.poisson_ratio};
  options.grain = {scene.grains.young_modulus, scene.grains.poisson_ratio};
  options.restitution = colloids.restitution;
  options.friction = colloids.friction;
  options.step = std::min(scene.fidelity.dem_step, advised_step(options));
  options.long_range_forces = regime.colloids->models.long_range_dlvo.needed;
  options.permanent_bonds = scene.bonds == Bonds::permanent;
  options.lubrication = scene.fidelity.lubrication == Lubrication::full;
  options.lubrication_cell = cell;
  options.upper_wall_speed = scene.drive.shear_rate.value_or(0.0) * options.box.size.z;
  return options;
}

void refuse(const Scene& scene, const Regime& regime) {
  require(!regime.colloids->models.brownian.needed, "/fidelity/tier", [&] {
    return fmt::format(
        "the tier transient has no Brownian motion, but {}; expected "
        "\"one_way\" or \"quasi_steady\"",
        regime.colloids->models.brownian.reason);
  });
  for (std::size_t n = 0; n < scene.geometry.bodies.size(); ++n) {
    const Body& body = scene.geometry.bodies[n];
    require(body.force == Vec3{} && body.torque == Vec3{} && !body.velocity,
            fmt::format("/geometry/bodies/{}", n),
            "the tier transient starts with free bodies alone; expected no force, torque "
            "or velocity");
  }
}

}  // namespace

TransientLoop::TransientLoop(const Scene& scene, const RunOptions& options)
    : scene_(scene),
      options_(options),
      radius_(0.5 * scene.colloids->diameter),
      inlet_(clean_inlet(scene)),
      sequence_(make_injection_plan(scene, inlet_.capture_gap), options.seed),
      deposit_flow_(scene, choose_cells(scene, {}), options.threads),
      regime_(regime_of(scene, deposit_flow_)),
      contacts_(make_surface_model(
          scene, 6.0 * kPi * scene.fluid.viscosity * radius_ * inlet_.mean_speed)),
      surfaces_(scene.geometry.box, scene.geometry.spheres, hindrance_range(radius_)),
      deposit_(scene, deposit_flow_, surfaces_),
      rest_(inlet_.mean_speed, radius_),
      flow_(scene, flow_options(scene)),
      dem_(dem_options(scene, contacts_, regime_, flow_.cell_at_bodies()),
           scene.geometry.spheres),
      last_checkpoint_(std::chrono::steady_clock::now()) {
  refuse(scene, regime_);
  Realisation& r = state_.realisation;
  r.seed = options.seed;
  r.tier = "transient";
  r.tier_reason = options.tier_reason;
}

std::optional<Realisation> TransientLoop::run() {
  cost_ = RunCost();
  if (!options_.checkpoint.empty() && std::filesystem::exists(options_.checkpoint)) {
    resume();
  } else {
    begin();
  }
  while (!over_) {
    if (stopped()) {
      save();
      return std::nullopt;
    }
    step();
    if (options_.progress) {
      options_.progress({state_.time, scene_.duration,
                         static_cast<long>(state_.realisation.retained.size()),
                         deposit_.critical().value});
    }
  }
  finish();
  state_.realisation.cost = cost_.so_far();
  return std::move(state_.realisation);
}

// The first ids are those of the colloids that are there from the beginning.  The liquid
// has come to its steady motion around them before time begins.
void TransientLoop::begin() {
  if (scene_.fidelity.coupling == Coupling::explicit_step) {
    const double relaxation = regime_.colloids->relaxation_time;
    std::fputs(
        fmt::format("coupling explicit: stable for flow steps below about {:.1e} s, less "
                    "where gaps are narrow (MODEL T8)\n",
                    kExplicitLimit * relaxation)
            .c_str(),
        stderr);
  }
  for (const Body& body : scene_.geometry.bodies) {
    const int id = static_cast<int>(state_.bodies.size());
    insert({id, 0.0, body.sphere.center}, body.sphere.center, {});
    state_.realisation.injections.push_back({id, 0.0, 0.0, body.sphere.center});
  }
  first_injected_ = static_cast<int>(state_.bodies.size());
  std::vector<FlowBody> bodies = flow_bodies(0.0);
  for (FlowBody& body : bodies) {
    body.free = false;
  }
  const double width = deposit_.critical().value;
  const double viscous_time =
      width * width * scene_.fluid.density / scene_.fluid.viscosity;
  for (int n = 0; n < kMostSettling; ++n) {
    const double dt = std::min(kSettlingStep * viscous_time,
                               scene_.fidelity.courant * flow_.courant_time());
    if (flow_.settle(dt, kSettled, 2, bodies) == 1) {
      break;
    }
  }
}

bool TransientLoop::stopped() {
  // All ranks at the same step: signals reach them at different moments.
  const bool asked = options_.stop != nullptr && *options_.stop;
  if (largest_over_ranks(asked ? 1.0 : 0.0) > 0.0) {
    return true;
  }
  if (!options_.checkpoint.empty()) {
    const bool due = this_rank() == 0 &&
                     seconds_since(last_checkpoint_) >= options_.checkpoint_interval;
    if (largest_over_ranks(due ? 1.0 : 0.0) > 0.0) {
      save();
    }
  }
  return false;
}

void TransientLoop::save() {
  if (options_.checkpoint.empty()) {
    return;
  }
  Checkpoint checkpoint;
  checkpoint.identity = run_identity(scene_, options_.seed, "transient");
  checkpoint.realisation = state_.realisation;
  checkpoint.realisation.cost = cost_.so_far();
  pack(state_, checkpoint.reals, checkpoint.integers);
  flow_.save(checkpoint.reals, checkpoint.integers);
  const std::string dem = dem_.save();
  std::vector<std::int64_t>& bytes = checkpoint.integers["dem"];
  bytes.assign(dem.begin(), dem.end());
  checkpoint.integers["dem_steps"] = {dem_steps_};
  std::vector<double>& forces = checkpoint.reals["forces"];
  for (const auto* list : {&means_, &loads_}) {
    for (const auto& [id, mean] : *list) {
      forces.insert(forces.end(),
                    {static_cast<double>(id), mean.force.x, mean.force.y, mean.force.z,
                     mean.torque.x, mean.torque.y, mean.torque.z});
    }
    checkpoint.integers["force_counts"].push_back(
        static_cast<std::int64_t>(list->size()));
  }
  deposit_.save(checkpoint);
  checkpoint.integers["first_injected"] = {first_injected_};
  if (this_rank() == 0) {
    write_checkpoint(options_.checkpoint, checkpoint);
  }
  last_checkpoint_ = std::chrono::steady_clock::now();
}

void TransientLoop::resume() {
  const Checkpoint checkpoint = read_checkpoint(
      options_.checkpoint, run_identity(scene_, options_.seed, "transient"));
  state_.realisation = checkpoint.realisation;
  cost_.resume(checkpoint.realisation.cost);
  unpack(checkpoint.reals, checkpoint.integers, state_);
  deposit_.restore(checkpoint, state_);
  first_injected_ = static_cast<int>(checkpoint.integers.at("first_injected").at(0));
  dem_steps_ = static_cast<long>(checkpoint.integers.at("dem_steps").at(0));
  const std::vector<double>& forces = checkpoint.reals.at("forces");
  std::size_t n = 0;
  for (int list = 0; list < 2; ++list) {
    auto& to = list == 0 ? means_ : loads_;
    const auto size =
        checkpoint.integers.at("force_counts").at(static_cast<std::size_t>(list));
    for (std::int64_t i = 0; i < size; ++i, n += 7) {
      const double* v = &forces.at(n);
      to[static_cast<int>(v[0])] = {{v[1], v[2], v[3]}, {v[4], v[5], v[6]}};
    }
  }
  const std::vector<std::int64_t>& bytes = checkpoint.integers.at("dem");
  dem_.restore(std::string(bytes.begin(), bytes.end()));
  flow_.restore(checkpoint.reals, checkpoint.integers);
}

Vec3 TransientLoop::weight() const {
  return scene_.gravity *
         (sphere_volume(radius_) * (scene_.colloids->density - scene_.fluid.density));
}

// In time by the flow rate of the flow itself.
double TransientLoop::next_injection_time() {
  const double rate = deposit_flow_.blocked() ? 0.0 : flow_.flow_rate();
  const double volume = sequence_.at(state_.next_injection).volume;
  if (!(rate > 0.0)) {
    return std::numeric_limits<double>::infinity();
  }
  return state_.time + std::max(0.0, (volume - state_.volume) / rate);
}

// By the Courant number, of the fluid and of colloids; the rest until `until` in equal
// parts, so that no step is tiny.
double TransientLoop::step_length(double until) const {
  double longest = scene_.fidelity.courant * flow_.courant_time();
  for (const RigidBody& body : state_.bodies) {
    longest = std::min(longest, scene_.fidelity.courant * flow_.cell_at_bodies() /
                                    std::max(norm(body.velocity), 1e-30));
  }
  const double left = until - state_.time;
  return left / std::max(1.0, std::ceil(left / longest));
}

void TransientLoop::step() {
  RunState& s = state_;
  const double output = next_output_time(s, scene_.duration);
  const double injection = next_injection_time();
  const double until = std::min({scene_.duration, output, injection});
  bool arrived = true;
  if (until > s.time) {
    const double dt = deposit_flow_.blocked() ? until - s.time : step_length(until);
    // Not by comparing sums: dt times the number of steps is `until` only nearly.
    arrived = dt > 0.999999 * (until - s.time);
    if (!deposit_flow_.blocked()) {
      s.volume += flow_.flow_rate() * dt;
      move(dt);
    }
    s.time = arrived ? until : s.time + dt;
    handle_exits();
    handle_rest();
    inject_waiting(s, [this](int index) { return inject(index); });
  }
  if (over_) {
    return;
  }
  if (arrived && injection <= until) {
    s.volume = sequence_.at(s.next_injection).volume;
    inject_next(s, sequence_, first_injected_,
                [this](int index) { return inject(index); });
  }
  if (arrived && output <= until) {
    record();
    ++s.next_output;
  }
  over_ = over_ || (arrived && until >= scene_.duration);
}

// As the flow sees them over a step of dt.
std::vector<FlowBody> TransientLoop::flow_bodies(double dt) const {
  const bool implicit = scene_.fidelity.coupling == Coupling::implicit;
  std::vector<FlowBody> out;
  for (const RigidBody& body : state_.bodies) {
    FlowBody b;
    b.sphere = {body.centre, radius_};
    b.free = implicit;
    b.mass = sphere_volume(radius_) * scene_.colloids->density;
    b.velocity = body.velocity;
    b.spin = body.spin;
    const Mean& mean = means_.at(body.members.front().id);
    b.force = mean.force;
    b.torque = mean.torque;
    out.push_back(halfway(b, dt));
  }
  for (const RetainedColloid& colloid : state_.realisation.retained) {
    FlowBody b;
    b.sphere = {colloid.position, radius_};
    out.push_back(b);
  }
  return out;
}

DemLoad TransientLoop::load_of(int id, const FlowResponse& response) const {
  DemLoad load;
  load.id = id;
  load.force = response.force;
  load.torque = response.torque;
  load.velocity = response.velocity;
  load.spin = response.spin;
  if (scene_.fidelity.coupling == Coupling::implicit) {
    // Never more than the true resistance, so that forces found in the last interval and
    // those of this one approach each other (MODEL T7).
    load.drag = 6.0 * kPi * scene_.fluid.viscosity * radius_;
    load.torsion = 8.0 * kPi * scene_.fluid.viscosity * radius_ * radius_ * radius_;
  }
  return load;
}

void TransientLoop::move(double dt) {
  const std::vector<FlowResponse> responses = flow_.step(dt, flow_bodies(dt));
  std::vector<DemLoad> loads;
  loads_.clear();
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    const int id = state_.bodies[b].members.front().id;
    loads.push_back(load_of(id, responses[b]));
    loads_[id] = {responses[b].force, responses[b].torque};
  }
  const DemStep moved = dem_.advance(dt, loads);
  dem_steps_ += moved.steps;
  for (const DemMean& mean : moved.means) {
    means_[mean.id] = {mean.force, mean.torque};
  }
  take_states();
  handle_events(moved.events);
}

std::size_t TransientLoop::place_of(int id) const {
  const auto found =
      std::find_if(state_.bodies.begin(), state_.bodies.end(),
                   [&](const RigidBody& body) { return body.members.front().id == id; });
  return static_cast<std::size_t>(found - state_.bodies.begin());
}

// Where the discrete elements have brought the colloids, and what they are bonded to.
void TransientLoop::take_states() {
  for (const DemState& state : dem_.states()) {
    const std::size_t b = place_of(state.id);
    if (b == state_.bodies.size()) {
      continue;
    }
    RigidBody& body = state_.bodies[b];
    body.centre = state.position;
    body.velocity = state.velocity;
    body.spin = state.spin;
    body.bonds.clear();
    if (!std::isfinite(dot(body.centre, body.centre))) {
      throw ConvergenceError(
          fmt::format("position of colloid {}: not a finite number", state.id));
    }
  }
  for (const DemBond& bond : dem_.bonds()) {
    for (const auto& [self, other] :
         {std::pair(bond.first, bond.second), std::pair(bond.second, bond.first)}) {
      const std::size_t b = place_of(self);
      if (b < state_.bodies.size()) {
        state_.bodies[b].bonds.push_back(
            {0, {SurfaceId::Kind::colloid, other}, Vec3{}, 2.0 * radius_});
      }
    }
  }
}

void TransientLoop::handle_events(const std::vector<DemEvent>& events) {
  for (const DemEvent& event : events) {
    const double time = state_.time + event.time;
    for (const int id : {event.colloid, event.other}) {
      const bool colloid =
          id == event.colloid || event.kind == DemEvent::Kind::touched_mobile;
      const std::size_t b = place_of(id);
      if (!colloid || b == state_.bodies.size()) {
        continue;
      }
      MobileColloid& member = state_.bodies[b].members.front();
      if (event.kind == DemEvent::Kind::bond_broken) {
        member.contact_time = kNotYet;
      } else if (std::isnan(member.contact_time)) {
        member.contact_time = time;
      }
    }
    if (event.kind == DemEvent::Kind::touched_grain ||
        event.kind == DemEvent::Kind::touched_wall) {
      if (place_of(event.colloid) < state_.bodies.size()) {
        arrest(event.colloid, time);
      }
    }
  }
}

// A colloid and those that rigid bonds join to it, as one body: itself first.
RigidBody TransientLoop::aggregate_of(int id) const {
  std::vector<int> members{id};
  for (std::size_t n = 0; n < members.size(); ++n) {
    for (const DemBond& bond : dem_.bonds()) {
      const int self = members[n];
      if (!bond.rigid || (bond.first != self && bond.second != self)) {
        continue;
      }
      const int other = bond.first == self ? bond.second : bond.first;
      if (std::find(members.begin(), members.end(), other) == members.end() &&
          place_of(other) < state_.bodies.size()) {
        members.push_back(other);
      }
    }
  }
  RigidBody body = state_.bodies[place_of(id)];
  body.bonds.clear();
  for (std::size_t n = 1; n < members.size(); ++n) {
    RigidBody other = state_.bodies[place_of(members[n])];
    other.bonds.clear();
    const Vec3 apart = body.position(0) - other.centre;
    body = joined(body, other,
                  apart - shortest(surfaces_.box(), body.position(0), other.centre));
  }
  return body;
}

void TransientLoop::arrest(int id, double time) {
  const RigidBody body = aggregate_of(id);
  BodyWrench held;
  for (const MobileColloid& member : body.members) {
    const auto load = loads_.find(member.id);
    if (load != loads_.end()) {
      held.force += load->second.force;
      held.torque += load->second.torque;
    }
  }
  const RetentionContext context{surfaces_,
                                 contacts_.rules,
                                 radius_,
                                 sequence_.plan().upstream(),
                                 contacts_.grain.pull_off,
                                 contacts_.wall.pull_off,
                                 contacts_.colloid.pull_off};
  std::vector<RetainedColloid> retained = describe_retention(context, body, 0, held);
  for (const RetainedColloid& colloid : retained) {
    const int member = static_cast<int>(colloid.colloid);
    dem_.hold(member);
    means_.erase(member);
    state_.bodies.erase(state_.bodies.begin() +
                        static_cast<std::ptrdiff_t>(place_of(member)));
  }
  deposit_.add(std::move(retained), time, state_);
  over_ = over_ || deposit_.ends_run(state_.realisation);
}

void TransientLoop::handle_exits() {
  for (std::size_t b = 0; b < state_.bodies.size();) {
    const int id = state_.bodies[b].members.front().id;
    if (distance_to_exit(surfaces_.box(), state_.bodies[b].centre, radius_) > 0.0) {
      ++b;
      continue;
    }
    dem_.remove(id);
    means_.erase(id);
    state_.bodies.erase(state_.bodies.begin() + static_cast<std::ptrdiff_t>(b));
    ++state_.realisation.counts.traversed;
    state_.realisation.last_traversal = state_.time;
  }
}

// Tied to the deposit or wedged, and slow.
void TransientLoop::handle_rest() {
  std::vector<NearSurface> near;
  std::vector<int> resting;
  for (RigidBody& body : state_.bodies) {
    surfaces_.near(body.centre, near);
    const auto touching =
        std::count_if(near.begin(), near.end(), [&](const NearSurface& surface) {
          const double gap = contact_gap(contacts_.rules, surfaces_.box(), surface.id);
          return is_surface(surfaces_.box(), surface.id) &&
                 surface.distance - radius_ <= gap + rest_.travel();
        });
    const bool bonded =
        std::any_of(body.bonds.begin(), body.bonds.end(), [&](const Bond& bond) {
          return place_of(bond.fixed.index) == state_.bodies.size();
        });
    const bool held = (bonded || touching >= 2) && !deposit_flow_.blocked();
    if (rest_.at_rest(body, held, norm(body.velocity), state_.time)) {
      resting.push_back(body.members.front().id);
    }
  }
  for (const int id : resting) {
    if (place_of(id) < state_.bodies.size()) {
      arrest(id, state_.time);
    }
  }
}

// False if something is in the way.
bool TransientLoop::inject(int index) {
  const InjectedColloid& colloid = sequence_.at(index);
  if (!has_room(state_, surfaces_, colloid.position,
                2.0 * radius_ + contacts_.rules.colloid_gap)) {
    return false;
  }
  Vec3 velocity = sequence_.plan().upstream() * -inlet_.mean_speed;
  if (scene_.colloids->injection.release_velocity == ReleaseVelocity::local) {
    velocity = flow_.velocity_at(colloid.position);
  }
  const int id = first_injected_ + index;
  insert({id, state_.time, colloid.position}, colloid.position, velocity);
  state_.realisation.injections.at(static_cast<std::size_t>(id)).time = state_.time;
  return true;
}

void TransientLoop::insert(const MobileColloid& colloid, const Vec3& position,
                           const Vec3& velocity) {
  RigidBody body = single(colloid, position);
  body.velocity = velocity;
  state_.bodies.push_back(body);
  means_[colloid.id] = {weight(), {}};
  DemState state;
  state.id = colloid.id;
  state.position = position;
  state.velocity = velocity;
  dem_.add(state);
}

void TransientLoop::record() {
  record_output(state_, deposit_, deposit_flow_.permeability(), first_injected_, radius_);
}

void TransientLoop::finish() {
  record_end(state_, scene_, deposit_, deposit_flow_.permeability(), first_injected_);
  const TransientFlowCounts& flow = flow_.counts();
  state_.realisation.deterministic = {
      {"steps", static_cast<double>(flow.steps)},
      {"dem_steps", static_cast<double>(dem_steps_)},
      {"grids", static_cast<double>(flow.grids)},
      {"cells", static_cast<double>(flow.cells)},
      {"momentum_iterations", static_cast<double>(flow.momentum_iterations)},
      {"pressure_iterations", static_cast<double>(flow.pressure_iterations)},
      {"flow_solves", static_cast<double>(deposit_flow_.solves())},
      {"injections_delayed", static_cast<double>(state_.times_delayed)},
      {"bonds_broken", static_cast<double>(dem_.bonds_broken())},
      {"grain_gap_m", contacts_.rules.grain_gap},
      {"colloid_gap_m", contacts_.rules.colloid_gap}};
}

}  // namespace colloid
