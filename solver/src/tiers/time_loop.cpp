#include "tiers/time_loop.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/constants.h"
#include "core/error.h"
#include "physics/barrier_escape.h"
#include "tiers/retention.h"
#include "tiers/run_record.h"

namespace colloid {

namespace {

constexpr int kEscapePushes = 24;       // of the table of escape rates
constexpr double kThermalTravel = 0.1;  // per thermal step, over the radius or the gap
constexpr long kPairsPerBody = 3;       // of normal draws: six numbers
constexpr int kMostIdle = 100;          // steps of no length in a row

IntegratorOptions integrator_options(const Scene& scene, const LoopParts& parts) {
  IntegratorOptions options;
  options.radius = 0.5 * scene.colloids->diameter;
  options.tolerance = parts.step_tolerance;
  options.rules = parts.contacts.rules;
  return options;
}

}  // namespace

TimeLoop::TimeLoop(const Scene& scene, const RunOptions& options, const LoopParts& parts)
    : scene_(scene),
      options_(options),
      parts_(parts),
      radius_(0.5 * scene.colloids->diameter),
      sequence_(parts.injections, options.seed),
      random_(options.seed),
      integrator_(integrator_options(scene, parts), parts.motion, parts.surfaces),
      deposit_(scene, parts.flow, parts.surfaces),
      rest_(parts.inlet_speed, radius_),
      last_checkpoint_(std::chrono::steady_clock::now()) {
  Realisation& r = state_.realisation;
  r.seed = options.seed;
  r.tier = parts.tier;
  r.tier_reason = options.tier_reason + "; " + parts.validity;
  begin_with_bodies();
  const PairContact& grain = parts.contacts.grain;
  if (parts.brownian && !parts.contacts.rules.grains_attach &&
      grain.analysis.primary_minimum) {
    EscapeConditions conditions;
    conditions.viscosity = scene.fluid.viscosity;
    for (int n = 0; n <= kEscapePushes; ++n) {
      const double push = grain.analysis.largest_repulsion.force * n / kEscapePushes;
      conditions.force_towards = push;
      const double time = barrier_escape(grain.forces, grain.analysis, conditions).time;
      escape_rates_.emplace_back(push, 1.0 / time);
    }
  }
}

// The first ids are those of the colloids that are there from the beginning.
void TimeLoop::begin_with_bodies() {
  for (const Body& body : scene_.geometry.bodies) {
    const int id = static_cast<int>(state_.bodies.size());
    const Vec3& place = body.sphere.center;
    state_.bodies.push_back(single({id, 0.0, place}, place));
    state_.realisation.injections.push_back({id, 0.0, 0.0, place});
  }
  first_injected_ = static_cast<int>(state_.bodies.size());
}

std::optional<Realisation> TimeLoop::run() {
  cost_ = RunCost();
  resume();
  integrator_.refresh(state_.bodies);
  integrator_.restore(state_.next_step, state_.counts);
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
  state_.realisation.cost = cost();
  NamedNumbers unused;
  parts_.motion.record(state_.realisation.deterministic, unused);
  return std::move(state_.realisation);
}

NamedNumbers TimeLoop::cost() const {
  NamedNumbers more{{"flow_seconds", parts_.flow.seconds()},
                    {"flow_work_units", parts_.flow.work_units()}};
  NamedNumbers unused;
  parts_.motion.record(unused, more);
  return cost_.so_far(more);
}

bool TimeLoop::stopped() {
  if (options_.stop != nullptr && *options_.stop) {
    return true;
  }
  if (!options_.checkpoint.empty() &&
      seconds_since(last_checkpoint_) >= options_.checkpoint_interval) {
    save();
  }
  return false;
}

void TimeLoop::save() {
  if (options_.checkpoint.empty()) {
    return;
  }
  state_.next_step = integrator_.next_step();
  state_.counts = integrator_.counts();
  Checkpoint checkpoint;
  checkpoint.identity = run_identity(scene_, options_.seed, parts_.tier);
  checkpoint.realisation = state_.realisation;
  checkpoint.realisation.cost = cost();
  pack(state_, checkpoint.reals, checkpoint.integers);
  deposit_.save(checkpoint);
  checkpoint.reals["motion"] = parts_.motion.state();
  write_checkpoint(options_.checkpoint, checkpoint);
  last_checkpoint_ = std::chrono::steady_clock::now();
}

void TimeLoop::resume() {
  if (options_.checkpoint.empty() || !std::filesystem::exists(options_.checkpoint)) {
    return;
  }
  const Checkpoint checkpoint = read_checkpoint(
      options_.checkpoint, run_identity(scene_, options_.seed, parts_.tier));
  state_.realisation = checkpoint.realisation;
  cost_.resume(checkpoint.realisation.cost);
  unpack(checkpoint.reals, checkpoint.integers, state_);
  deposit_.restore(checkpoint, state_);
  for (const DepositBatch& batch : state_.deposit) {
    parts_.motion.deposit_grew(batch.spheres);
  }
  parts_.motion.restore(checkpoint.reals.at("motion"));
}

double TimeLoop::next_injection_time() {
  const double rate = parts_.flow.flow_rate();
  const double volume = sequence_.at(state_.next_injection).volume;
  if (!(rate > 0.0)) {
    return std::numeric_limits<double>::infinity();
  }
  return state_.time + (volume - state_.volume) / rate;
}

void TimeLoop::step() {
  RunState& s = state_;
  const double output = next_output_time(s, scene_.duration);
  const double injection = next_injection_time();
  const double until = std::min({scene_.duration, output, injection});
  const double longest = std::max(0.0, until - s.time);
  double taken = longest;
  if (longest > 0.0) {
    if (parts_.motion.begin_step(s.bodies, integrator_.contacts(),
                                 integrator_.motion())) {
      integrator_.refresh(s.bodies);
    }
    const double allowed = std::min(longest, parts_.motion.longest_step(s.bodies));
    std::optional<Forcing> forcing;
    if (parts_.brownian && !s.bodies.empty()) {
      forcing = thermal_forcing(allowed);  // as strong as its step is short
      ++s.thermal_steps;
    }
    taken = integrator_.advance(s.bodies, allowed, forcing);
    for (const RigidBody& body : s.bodies) {
      if (!std::isfinite(dot(body.centre, body.centre))) {
        throw ConvergenceError("position of a colloid: not a finite number");
      }
    }
  }
  const bool arrived = taken >= longest;
  s.volume += parts_.flow.flow_rate() * taken;
  s.time = arrived ? until : s.time + taken;
  const long retained = static_cast<long>(s.realisation.retained.size());
  const std::size_t bodies = s.bodies.size();
  after_step();
  handle_pushes(taken);
  if (taken == 0.0 && longest > 0.0 && bodies == s.bodies.size() &&
      retained == static_cast<long>(s.realisation.retained.size()) &&
      ++idle_steps_ > kMostIdle) {
    throw ConvergenceError("motion of colloids: contacts do not settle");
  }
  if (taken > 0.0) {
    idle_steps_ = 0;
  }
  if (over_) {
    return;
  }
  if (arrived && injection <= until) {
    s.volume = sequence_.at(s.next_injection).volume;
    inject_next(s, sequence_, first_injected_,
                [this](int index) { return inject(index); });
    after_step();
  }
  if (arrived && output <= until) {
    record();
    ++s.next_output;
  }
  over_ = over_ || (arrived && until >= scene_.duration);
}

// Everything that a new state may have brought about, until nothing is left.
void TimeLoop::after_step() {
  while (!over_ && handle_touch()) {
  }
  handle_exits();
  while (!over_ && handle_broken_bonds()) {
  }
  handle_rest();
  if (!over_) {
    inject_waiting(state_, [this](int index) { return inject(index); });
  }
}

// False if something is in the way.
bool TimeLoop::inject(int index) {
  const InjectedColloid& colloid = sequence_.at(index);
  if (!has_room(state_, parts_.surfaces, colloid.position,
                2.0 * radius_ + parts_.contacts.rules.colloid_gap)) {
    return false;
  }
  MobileColloid mobile;
  mobile.id = first_injected_ + index;
  mobile.injection_time = state_.time;
  mobile.injection_position = colloid.position;
  state_.bodies.push_back(single(mobile, colloid.position));
  state_.realisation.injections.at(static_cast<std::size_t>(mobile.id)).time =
      state_.time;
  integrator_.refresh(state_.bodies);
  return true;
}

void TimeLoop::bond(RigidBody& body, const Touch& touch) {
  const auto m = static_cast<std::size_t>(touch.contact.member);
  const NearSurface surface =
      parts_.surfaces.seen_from(body.position(m), touch.contact.fixed);
  const double distance = surface.distance + surface.radius;
  body.bonds.push_back({touch.contact.member, touch.contact.fixed,
                        body.position(m) - surface.normal * distance, distance});
  if (std::isnan(body.members[m].contact_time)) {
    body.members[m].contact_time = state_.time;
  }
}

void TimeLoop::merge(const Contact& contact) {
  const auto b = static_cast<std::size_t>(contact.other_body);
  RigidBody& first = state_.bodies[static_cast<std::size_t>(contact.body)];
  RigidBody& second = state_.bodies[b];
  for (RigidBody* body : {&first, &second}) {
    for (MobileColloid& member : body->members) {
      if (std::isnan(member.contact_time)) {
        member.contact_time = state_.time;
      }
    }
  }
  // The image that touches; of two long bodies the centres may be nearer by another.
  const Vec3 from = first.position(static_cast<std::size_t>(contact.member));
  const Vec3 to = second.position(static_cast<std::size_t>(contact.other_member));
  const Vec3 shift = from - to - shortest(parts_.surfaces.box(), from, to);
  first = joined(first, second, shift);
  state_.bodies.erase(state_.bodies.begin() + static_cast<std::ptrdiff_t>(b));
}

// One consequence of surfaces that touch; false if there is none left.
bool TimeLoop::handle_touch() {
  const ContactRules& rules = parts_.contacts.rules;
  const Box& box = parts_.surfaces.box();
  for (const Touch& touch :
       find_touches(state_.bodies, parts_.surfaces, rules, radius_)) {
    if (!sticks(touch, rules, box)) {
      continue;
    }
    const auto b = static_cast<std::size_t>(touch.contact.body);
    const auto m = static_cast<std::size_t>(touch.contact.member);
    if (touch.contact.other_body >= 0) {
      merge(touch.contact);
    } else if (touch.contact.fixed.kind == SurfaceId::Kind::colloid) {
      RigidBody& body = state_.bodies[b];
      bond(body, touch);
      if (motions_at_rest(bond_contacts(body, box, radius_)).cols() == 0) {
        arrest(b, m);
        return true;
      }
    } else {
      arrest(b, m);
      return true;
    }
    integrator_.refresh(state_.bodies);
    return true;
  }
  return false;
}

double TimeLoop::escape_rate(double push) const {
  for (std::size_t n = 1; n < escape_rates_.size(); ++n) {
    const auto& [p0, r0] = escape_rates_[n - 1];
    const auto& [p1, r1] = escape_rates_[n];
    if (push <= p1) {
      const double t = (push - p0) / (p1 - p0);
      // Rates change by orders of magnitude: straight in their logarithms.
      return r0 > 0.0 && r1 > 0.0 ? r0 * std::pow(r1 / r0, t) : r0 * (1.0 - t) + r1 * t;
    }
  }
  return escape_rates_.empty() ? 0.0 : std::numeric_limits<double>::infinity();
}

// Surfaces that do not stick by touching: pressed together hard enough, or brought
// together by heat.
void TimeLoop::handle_pushes(double step) {
  const auto& contacts = integrator_.contacts();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (contact.other_body >= 0) {
      continue;
    }
    const double push = integrator_.motion().contact_push[c];
    const auto b = static_cast<std::size_t>(contact.body);
    const auto m = static_cast<std::size_t>(contact.member);
    MobileColloid& member = state_.bodies[b].members[m];
    bool attached = push > attaching_push(parts_.contacts.rules, parts_.surfaces.box(),
                                          contact.fixed);
    if (contact.fixed.kind == SurfaceId::Kind::grain && !escape_rates_.empty()) {
      member.expected_escapes += step * escape_rate(push);
      const double limit = random_.exponential(
          {RandomPurpose::escape, static_cast<std::uint32_t>(member.id), 0});
      attached = attached || member.expected_escapes >= limit;
    }
    if (attached) {  // another one is found after the next step
      arrest(b, m);
      return;
    }
  }
}

bool TimeLoop::handle_broken_bonds() {
  if (scene_.bonds == Bonds::permanent) {
    return false;
  }
  const Box& box = parts_.surfaces.box();
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    RigidBody& body = state_.bodies[b];
    if (!body.bonded()) {
      continue;
    }
    const BodyWrench& wrench = integrator_.motion().bond_wrench[b];
    Vector6 load;
    load << eigen(wrench.force), eigen(wrench.torque) / radius_;
    const std::vector<Vector3> forces =
        contact_loads(bond_contacts(body, box, radius_), load);
    for (std::size_t n = 0; n < body.bonds.size(); ++n) {
      const auto m = static_cast<std::size_t>(body.bonds[n].member);
      const Vec3 e = shortest(box, body.position(m), body.bonds[n].anchor);
      const Vec3 normal = e * (1.0 / norm(e));
      if (-forces[n].dot(eigen(normal)) > parts_.contacts.colloid.pull_off) {
        // Out of touch, or it would bond again at once.
        const double gap = parts_.contacts.rules.colloid_gap;
        displace(body, normal * (2.0 * contact_tolerance(gap, radius_)), {});
        body.bonds.erase(body.bonds.begin() + static_cast<std::ptrdiff_t>(n));
        if (!body.attached()) {
          body.members.front().contact_time = kNotYet;
        }
        ++state_.bonds_broken;
        integrator_.refresh(state_.bodies);
        return true;
      }
    }
  }
  return false;
}

void TimeLoop::handle_exits() {
  bool left = false;
  for (std::size_t b = 0; b < state_.bodies.size();) {
    RigidBody& body = state_.bodies[b];
    std::size_t gone = body.size();
    for (std::size_t m = 0; m < body.size() && gone == body.size(); ++m) {
      if (distance_to_exit(parts_.surfaces.box(), body.position(m), radius_) <=
          kContactTolerance * radius_) {
        gone = m;
      }
    }
    if (gone == body.size()) {
      ++b;
      continue;
    }
    left = true;
    ++state_.realisation.counts.traversed;
    state_.realisation.last_traversal = state_.time;
    if (body.size() == 1) {
      state_.bodies.erase(state_.bodies.begin() + static_cast<std::ptrdiff_t>(b));
    } else {
      body = without(body, gone);
    }
  }
  if (left) {
    integrator_.refresh(state_.bodies);
  }
}

// Tied to the deposit or wedged, and slow.
void TimeLoop::handle_rest() {
  for (std::size_t b = 0; b < state_.bodies.size() && !over_; ++b) {
    RigidBody& body = state_.bodies[b];
    const auto touching =
        std::count_if(integrator_.contacts().begin(), integrator_.contacts().end(),
                      [&](const Contact& c) {
                        // The inlet's plane holds back, but nothing can wedge against it.
                        return c.body == static_cast<int>(b) &&
                               is_surface(parts_.surfaces.box(), c.fixed);
                      });
    double fastest = 0.0;
    for (std::size_t m = 0; m < body.size(); ++m) {
      fastest = std::max(fastest, norm(body.velocity_of(m)));
    }
    const bool held = (body.bonded() || touching >= 2) && !parts_.flow.blocked();
    if (rest_.at_rest(body, held, fastest, state_.time)) {
      arrest(b, 0);
      --b;
    }
  }
}

void TimeLoop::arrest(std::size_t index, std::size_t member) {
  const RigidBody body = state_.bodies[index];
  const BodyWrench held = parts_.motion.held_wrenches(state_.bodies)[index];
  state_.bodies.erase(state_.bodies.begin() + static_cast<std::ptrdiff_t>(index));
  const RetentionContext context{parts_.surfaces,
                                 parts_.contacts.rules,
                                 radius_,
                                 parts_.injections.upstream(),
                                 parts_.contacts.grain.pull_off,
                                 parts_.contacts.wall.pull_off,
                                 parts_.contacts.colloid.pull_off};
  parts_.motion.deposit_grew(
      deposit_.add(describe_retention(context, body, member, held), state_.time, state_));
  over_ = over_ || deposit_.ends_run(state_.realisation);
  integrator_.refresh(state_.bodies);
}

// Wrenches for a step of at most `longest` in which heat moves nothing by more than a
// tenth of its gap or radius.  Their strength depends on the step's length.
Forcing TimeLoop::thermal_forcing(double longest) const {
  const double kT = parts_.contacts.grain.forces.thermal_energy();
  const double drag = 6.0 * kPi * scene_.fluid.viscosity * radius_;
  const double diffusivity = kT / drag;
  const double reach = kThermalTravel * radius_;
  Forcing forcing;
  forcing.step = std::min(longest, 0.5 * reach * reach / diffusivity);
  std::vector<NearSurface> near;
  double fastest = 0.0;
  for (const RigidBody& body : state_.bodies) {
    for (std::size_t m = 0; m < body.size(); ++m) {
      fastest = std::max(fastest, norm(body.velocity_of(m)));
      parts_.surfaces.near(body.position(m), near);
      for (const NearSurface& surface : near) {
        const double gap = surface.distance - radius_;
        if (gap > 0.0 && gap < radius_ && scene_.fidelity.hindrance != Hindrance::none) {
          // Diffusion along the normal slows down like h/a.
          forcing.step = std::min(forcing.step, 0.5 * kThermalTravel * kThermalTravel *
                                                    gap * radius_ / diffusivity);
        }
      }
    }
  }
  if (fastest > 0.0) {
    forcing.step = std::min(forcing.step, reach / fastest);
  }
  std::vector<Vector6> normals;
  for (const RigidBody& body : state_.bodies) {
    Vector6 six;
    for (long pair = 0; pair < kPairsPerBody; ++pair) {
      const auto draws = random_.normal_pair(
          {RandomPurpose::brownian, static_cast<std::uint32_t>(body.members.front().id),
           static_cast<std::uint64_t>(kPairsPerBody * state_.thermal_steps + pair)});
      six[2 * pair] = draws[0];
      six[2 * pair + 1] = draws[1];
    }
    normals.push_back(six);
  }
  forcing.wrenches = parts_.motion.thermal_wrenches(
      state_.bodies, normals, scene_.fluid.temperature, forcing.step);
  return forcing;
}

void TimeLoop::record() {
  record_output(state_, deposit_, parts_.flow.permeability(), first_injected_, radius_);
}

void TimeLoop::finish() {
  record_end(state_, scene_, deposit_, parts_.flow.permeability(), first_injected_);
  const IntegratorCounts& c = integrator_.counts();
  state_.realisation.deterministic = {
      {"steps", static_cast<double>(c.steps)},
      {"rejected_steps", static_cast<double>(c.rejected)},
      {"located_contacts", static_cast<double>(c.located)},
      {"velocity_evaluations", static_cast<double>(c.evaluations)},
      {"overlaps", static_cast<double>(c.overlaps)},
      {"deepest_overlap_m", c.deepest_overlap},
      {"flow_solves", static_cast<double>(parts_.flow.solves())},
      {"flow_iterations", static_cast<double>(parts_.flow.iterations())},
      {"injections_delayed", static_cast<double>(state_.times_delayed)},
      {"bonds_broken", static_cast<double>(state_.bonds_broken)},
      {"grain_gap_m", parts_.contacts.rules.grain_gap},
      {"colloid_gap_m", parts_.contacts.rules.colloid_gap}};
}

}  // namespace colloid
