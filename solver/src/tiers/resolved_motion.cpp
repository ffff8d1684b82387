#include "tiers/resolved_motion.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace colloid {

namespace {

// Part of an interval below which changes are not extrapolated from it.
constexpr double kShortInterval = 0.1;

Eigen::VectorXd as_vector(const Motion& motion) {
  Eigen::VectorXd v(6 * static_cast<Eigen::Index>(motion.velocity.size()));
  for (std::size_t b = 0; b < motion.velocity.size(); ++b) {
    v.segment<6>(6 * static_cast<Eigen::Index>(b)) << eigen(motion.velocity[b]),
        eigen(motion.spin[b]);
  }
  return v;
}

std::vector<MovingBody> moving(const std::vector<RigidBody>& bodies, double radius) {
  std::vector<MovingBody> out;
  for (const RigidBody& body : bodies) {
    out.push_back({body.centre, {}});
    for (std::size_t m = 0; m < body.size(); ++m) {
      out.back().spheres.push_back({body.position(m), radius});
    }
  }
  return out;
}

StokesOptions solver_options(const ResolvedOptions& options) {
  StokesOptions out;
  out.tolerance = options.tolerance;
  out.threads = options.threads;
  return out;
}

}  // namespace

ResolvedMotion::ResolvedMotion(const ResolvedOptions& options,
                               const StokesProblem& problem, const OneWayMotion& model)
    : options_(options), model_(model), solver_(problem, solver_options(options)) {}

// In intervals between solves.
double ResolvedMotion::elapsed(const std::vector<RigidBody>& bodies) const {
  for (const RigidBody& body : bodies) {
    for (std::size_t m = 0; m < body.size(); ++m) {
      if (body.members[m].id == clock_.colloid) {
        return std::min(1.0, norm(body.position(m) - clock_.position) / clock_.span);
      }
    }
  }
  return 0.0;
}

std::vector<BodyWrench> ResolvedMotion::errors(
    const std::vector<RigidBody>& bodies) const {
  const double time = elapsed(bodies);
  std::vector<BodyWrench> out(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t m = 0; m < bodies[b].size(); ++m) {
      const auto found = found_.find(bodies[b].members[m].id);
      if (found == found_.end()) {
        continue;
      }
      const BodyWrench& error = found->second.error;
      const BodyWrench& change = found->second.change;
      const Vec3 force = error.force + change.force * time;
      out[b].force += force;
      out[b].torque +=
          error.torque + change.torque * time + cross(bodies[b].arms[m], force);
    }
  }
  return out;
}

Motion ResolvedMotion::motion(const std::vector<RigidBody>& bodies,
                              const std::vector<Contact>& contacts,
                              const std::vector<BodyWrench>& extra) const {
  std::vector<BodyWrench> all = errors(bodies);
  for (std::size_t b = 0; b < extra.size(); ++b) {
    all[b].force += extra[b].force;
    all[b].torque += extra[b].torque;
  }
  return model_.motion(bodies, contacts, all);
}

std::vector<BodyWrench> ResolvedMotion::thermal_wrenches(
    const std::vector<RigidBody>& bodies, const std::vector<Vector6>& normals,
    double temperature, double step) const {
  return model_.thermal_wrenches(bodies, normals, temperature, step);
}

std::vector<BodyWrench> ResolvedMotion::held_wrenches(
    const std::vector<RigidBody>& bodies) const {
  return model_.held_wrenches(bodies);
}

// The bodies are others, or one has gone as far as it may.
bool ResolvedMotion::due(const std::vector<RigidBody>& bodies) const {
  std::size_t colloids = 0;
  for (const RigidBody& body : bodies) {
    colloids += body.size();
    for (std::size_t m = 0; m < body.size(); ++m) {
      const auto found = found_.find(body.members[m].id);
      if (found == found_.end() || found->second.mates != body.size() ||
          found->second.bonded != body.bonded() ||
          norm(body.position(m) - found->second.position) >=
              (1.0 - 1e-6) * options_.most_travel) {
        return true;
      }
    }
  }
  return colloids != found_.size();
}

bool ResolvedMotion::begin_step(const std::vector<RigidBody>& bodies,
                                const std::vector<Contact>& contacts,
                                const Motion& motion) {
  if (bodies.empty() || !due(bodies)) {
    return false;
  }
  solve(bodies, contacts, motion);
  return true;
}

// Until a colloid has gone as far as it may.
double ResolvedMotion::longest_step(const std::vector<RigidBody>& bodies) const {
  double longest = std::numeric_limits<double>::infinity();
  for (const RigidBody& body : bodies) {
    for (std::size_t m = 0; m < body.size(); ++m) {
      const auto found = found_.find(body.members[m].id);
      const double gone =
          found == found_.end() ? 0.0 : norm(body.position(m) - found->second.position);
      const double speed = norm(body.velocity_of(m));
      if (speed > 0.0) {
        longest = std::min(longest, (options_.most_travel - gone) / speed);
      }
    }
  }
  return std::max(longest, 0.0);
}

void ResolvedMotion::place(const std::vector<MovingBody>& bodies) {
  solver_.set_bodies(bodies);
  placed_ = bodies;
  seconds_ += solver_.statistics().setup_seconds;
}

void ResolvedMotion::solve(const std::vector<RigidBody>& bodies,
                           const std::vector<Contact>& contacts, const Motion& motion) {
  std::vector<Contact> pressed;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (motion.contact_push[c] > 0.0) {
      pressed.push_back(contacts[c]);
    }
  }
  const LinearMotion model = model_.linear(bodies, pressed);
  place(moving(bodies, options_.radius));
  BodyBalance balance;
  balance.given = Eigen::VectorXd::Zero(model.drive.size());
  balance.motions = model.motions;
  balance.load = model.load;
  balance.guess = model.resistance;
  if (options_.cell > 0.0) {
    balance.resistance = model_.lubrication(bodies, options_.cell);
  }
  solver_.set_body_motion(as_vector(motion));
  const StokesStatistics& s = solver_.solve(balance);
  ++solves_;
  iterations_ += s.iterations;
  work_units_ += s.work_units;
  seconds_ += s.seconds;

  const Eigen::VectorXd v = solver_.body_motion();
  Eigen::VectorXd error =
      solver_.body_wrench() + model.load + model.resistance * v - model.drive;
  if (options_.cell > 0.0) {
    error -= balance.resistance * v;
  }
  keep(bodies, error);
}

void ResolvedMotion::keep(const std::vector<RigidBody>& bodies,
                          const Eigen::VectorXd& error) {
  const std::map<int, Found> before = std::move(found_);
  found_.clear();
  clock_ = {};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const RigidBody& body = bodies[b];
    const double share = 1.0 / static_cast<double>(body.size());
    const auto at = 6 * static_cast<Eigen::Index>(b);
    // The arms add up to zero, so equal forces make no torque about the centre.
    const Vec3 force = plain(error.segment<3>(at)) * share;
    const Vec3 torque = plain(error.segment<3>(at + 3)) * share;
    for (std::size_t m = 0; m < body.size(); ++m) {
      const Vec3 x = body.position(m);
      Found found{x, body.size(), body.bonded(), {force, torque}, {}};
      const auto old = before.find(body.members[m].id);
      if (old != before.end() && old->second.mates == found.mates &&
          old->second.bonded == found.bonded) {
        found.change = {force - old->second.error.force,
                        torque - old->second.error.torque};
        const double span = norm(x - old->second.position);
        if (span > clock_.span) {
          clock_ = {body.members[m].id, x, span};
        }
      }
      found_[body.members[m].id] = found;
    }
  }
  // After a short interval little is known of the change.
  if (clock_.span < kShortInterval * options_.most_travel) {
    clock_ = {};
  }
}

void ResolvedMotion::deposit_grew(const std::vector<Sphere>& deposit) {
  place({});
  solver_.add_spheres(deposit);
  found_.clear();
}

void ResolvedMotion::record(NamedValues& counts, NamedValues& seconds) const {
  counts.emplace_back("resolved_solves", static_cast<double>(solves_));
  counts.emplace_back("resolved_iterations", static_cast<double>(iterations_));
  seconds.emplace_back("resolved_seconds", seconds_);
  seconds.emplace_back("resolved_work_units", work_units_);
}

namespace {

void append(std::vector<double>& out, const Vec3& v) {
  out.insert(out.end(), {v.x, v.y, v.z});
}

class Values {
 public:
  explicit Values(const std::vector<double>& values) : values_(values) {}
  double number() {
    require(next_ < values_.size(), "resolved motion", "is cut short");
    return values_[next_++];
  }
  std::size_t count() { return static_cast<std::size_t>(number()); }
  Vec3 vector() {
    Vec3 v;
    for (int a = 0; a < 3; ++a) {
      v[a] = number();
    }
    return v;
  }
  std::vector<double> rest() {
    return {values_.begin() + static_cast<std::ptrdiff_t>(next_), values_.end()};
  }

 private:
  const std::vector<double>& values_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<double> ResolvedMotion::state() const {
  std::vector<double> out{static_cast<double>(solves_), static_cast<double>(iterations_),
                          static_cast<double>(found_.size())};
  for (const auto& [id, found] : found_) {
    out.push_back(id);
    append(out, found.position);
    out.push_back(static_cast<double>(found.mates));
    out.push_back(found.bonded ? 1.0 : 0.0);
    append(out, found.error.force);
    append(out, found.error.torque);
    append(out, found.change.force);
    append(out, found.change.torque);
  }
  out.push_back(clock_.colloid);
  append(out, clock_.position);
  out.push_back(clock_.span);
  out.push_back(static_cast<double>(placed_.size()));
  for (const MovingBody& body : placed_) {
    append(out, body.centre);
    out.push_back(static_cast<double>(body.spheres.size()));
    for (const Sphere& sphere : body.spheres) {
      append(out, sphere.center);
      out.push_back(sphere.radius);
    }
  }
  const Eigen::VectorXd& v = solver_.body_motion();
  out.insert(out.end(), v.data(), v.data() + v.size());
  const std::vector<double> flow = solver_.state();
  out.insert(out.end(), flow.begin(), flow.end());
  return out;
}

void ResolvedMotion::restore(const std::vector<double>& state) {
  Values values(state);
  solves_ = static_cast<long>(values.number());
  iterations_ = static_cast<long>(values.number());
  found_.clear();
  for (std::size_t n = values.count(); n > 0; --n) {
    const int id = static_cast<int>(values.number());
    Found found;
    found.position = values.vector();
    found.mates = values.count();
    found.bonded = values.number() != 0.0;
    found.error.force = values.vector();
    found.error.torque = values.vector();
    found.change.force = values.vector();
    found.change.torque = values.vector();
    found_[id] = found;
  }
  clock_.colloid = static_cast<int>(values.number());
  clock_.position = values.vector();
  clock_.span = values.number();
  std::vector<MovingBody> bodies(values.count());
  for (MovingBody& body : bodies) {
    body.centre = values.vector();
    body.spheres.resize(values.count());
    for (Sphere& sphere : body.spheres) {
      sphere.center = values.vector();
      sphere.radius = values.number();
    }
  }
  place(bodies);
  Eigen::VectorXd v(6 * static_cast<Eigen::Index>(bodies.size()));
  for (Eigen::Index n = 0; n < v.size(); ++n) {
    v[n] = values.number();
  }
  solver_.set_body_motion(v);
  solver_.restore(values.rest());
}

}  // namespace colloid
