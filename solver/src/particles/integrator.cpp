#include "particles/integrator.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "particles/settle.h"

namespace colloid {

namespace {

constexpr double kSafety = 0.9;
constexpr double kMostGrowth = 4.0;
constexpr double kMostShrink = 0.2;
constexpr int kMostRejections = 60;
constexpr int kMostLocations = 60;
constexpr int kMostRounds = 3;  // of putting surfaces apart
constexpr int kSamplesWithin = 8;

// Bogacki & Shampine (1989), Appl. Math. Lett. 2, 321.
constexpr double kSecond = 0.5;
constexpr double kThird = 0.75;
constexpr std::array<double, 3> kSolution{2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0};
constexpr std::array<double, 4> kError{-5.0 / 72.0, 1.0 / 12.0, 1.0 / 9.0, -1.0 / 8.0};

// Rate of the rotation vector theta of a body that turns at w: the inverse of the
// exponential map's differential to second order (Iserles & Norsett 1999), enough for
// third-order steps.
Vec3 turn_rate(const Vec3& theta, const Vec3& w) {
  const Vec3 c = cross(theta, w);
  return w - 0.5 * c + (1.0 / 12.0) * cross(theta, c);
}

std::vector<RigidBody> displaced(const std::vector<RigidBody>& bodies,
                                 const std::vector<Vec3>& shift,
                                 const std::vector<Vec3>& turn) {
  std::vector<RigidBody> out = bodies;
  for (std::size_t b = 0; b < out.size(); ++b) {
    displace(out[b], shift[b], turn[b]);
  }
  return out;
}

}  // namespace

Integrator::Integrator(const IntegratorOptions& options, const MotionModel& model,
                       const FixedSurfaces& surfaces)
    : options_(options), model_(model), surfaces_(surfaces) {}

void Integrator::restore(double next_step, const IntegratorCounts& counts) {
  next_step_ = next_step;
  counts_ = counts;
}

Motion Integrator::evaluate(const std::vector<RigidBody>& bodies,
                            const std::optional<Forcing>& forcing) {
  ++counts_.evaluations;
  return model_.motion(bodies, contacts_,
                       forcing ? forcing->wrenches : std::vector<BodyWrench>{});
}

void Integrator::refresh(std::vector<RigidBody>& bodies) {
  refresh(bodies, find_touches(bodies, surfaces_, options_.rules, options_.radius));
}

void Integrator::refresh(std::vector<RigidBody>& bodies,
                         const std::vector<Touch>& touches) {
  contacts_.clear();
  for (const Touch& touch : touches) {
    if (!sticks(touch, options_.rules, surfaces_.box())) {
      contacts_.push_back(touch.contact);
    }
  }
  motion_ = evaluate(bodies, std::nullopt);
  fresh_ = true;
  take_velocities(bodies);
}

void Integrator::take_velocities(std::vector<RigidBody>& bodies) const {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].velocity = motion_.velocity[b];
    bodies[b].spin = motion_.spin[b];
  }
}

// Error over the tolerance: of the position over a, along near normals and towards near
// colloids over the gap.
double Integrator::error_of(const std::vector<RigidBody>& bodies,
                            const std::vector<Vec3>& shift,
                            const std::vector<Vec3>& turn) const {
  const double a = options_.radius;
  double worst = 0.0;
  std::vector<NearSurface> near;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t m = 0; m < bodies[b].size(); ++m) {
      const Vec3 error = shift[b] + cross(turn[b], bodies[b].arms[m]);
      worst = std::max(worst, norm(error) / a);
      surfaces_.near(bodies[b].position(m), near);
      for (const NearSurface& surface : near) {
        if (!is_surface(surfaces_.box(), surface.id)) {
          continue;
        }
        const double touching = contact_gap(options_.rules, surfaces_.box(), surface.id);
        const double gap = std::max(surface.distance - a, touching);
        if (gap < a && gap > 0.0) {
          worst = std::max(worst, std::abs(dot(error, surface.normal)) / gap);
        }
      }
      for (std::size_t other = b + 1; other < bodies.size(); ++other) {
        for (std::size_t om = 0; om < bodies[other].size(); ++om) {
          const Vec3 e = shortest(surfaces_.box(), bodies[b].position(m),
                                  bodies[other].position(om));
          const double r = norm(e);
          const double gap = std::max(r - 2.0 * a, options_.rules.colloid_gap);
          if (gap < a && gap > 0.0) {
            const Vec3 apart =
                error - shift[other] - cross(turn[other], bodies[other].arms[om]);
            worst = std::max(worst, std::abs(dot(apart, e)) / (r * gap));
          }
        }
      }
    }
  }
  return worst / options_.tolerance;
}

Integrator::Trial Integrator::attempt(const std::vector<RigidBody>& bodies, double step,
                                      const std::optional<Forcing>& forcing) {
  const std::size_t n = bodies.size();
  std::array<std::vector<Vec3>, 4> u;
  std::array<std::vector<Vec3>, 4> w;
  std::vector<Vec3> shift(n);
  std::vector<Vec3> turn(n);
  const auto take = [&](std::size_t stage, const Motion& motion) {
    u[stage] = motion.velocity;
    w[stage] = motion.spin;
    for (std::size_t b = 0; b < n; ++b) {
      w[stage][b] = turn_rate(turn[b], motion.spin[b]);
    }
  };
  take(0, motion_);
  const auto go = [&](double fraction, std::size_t stage) {
    for (std::size_t b = 0; b < n; ++b) {
      shift[b] = u[stage][b] * (fraction * step);
      turn[b] = w[stage][b] * (fraction * step);
    }
  };
  go(kSecond, 0);
  take(1, evaluate(displaced(bodies, shift, turn), forcing));
  go(kThird, 1);
  take(2, evaluate(displaced(bodies, shift, turn), forcing));
  const auto combine = [&](const auto& weights, std::vector<Vec3>& x,
                           std::vector<Vec3>& t) {
    for (std::size_t b = 0; b < n; ++b) {
      x[b] = Vec3{};
      t[b] = Vec3{};
      for (std::size_t s = 0; s < weights.size(); ++s) {
        x[b] += u[s][b] * (weights[s] * step);
        t[b] += w[s][b] * (weights[s] * step);
      }
    }
  };
  combine(kSolution, shift, turn);
  Trial trial;
  trial.bodies = displaced(bodies, shift, turn);
  trial.end = evaluate(trial.bodies, forcing);
  take(3, trial.end);
  std::vector<Vec3> shift_error(n);
  std::vector<Vec3> turn_error(n);
  combine(kError, shift_error, turn_error);
  trial.error = error_of(trial.bodies, shift_error, turn_error);
  return trial;
}

// The least margin, over its tolerance, of all contacts and passages that could come;
// those already in touch do not count.  Below -1: something was passed.
double Integrator::least_event(const std::vector<RigidBody>& bodies) const {
  const double a = options_.radius;
  double least = std::numeric_limits<double>::infinity();
  std::vector<NearSurface> near;
  const auto in_contact = [&](std::size_t b, std::size_t m, const SurfaceId& id) {
    const auto same = [&](const Contact& c) {
      return c.body == static_cast<int>(b) && c.member == static_cast<int>(m) &&
             c.fixed == id;
    };
    return std::any_of(contacts_.begin(), contacts_.end(), same) ||
           bodies[b].bonded_to(m, id);
  };
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t m = 0; m < bodies[b].size(); ++m) {
      const Vec3 x = bodies[b].position(m);
      const double exit_tolerance = kContactTolerance * a;
      least = std::min(least, distance_to_exit(surfaces_.box(), x, a) / exit_tolerance);
      surfaces_.near(x, near);
      for (const NearSurface& surface : near) {
        const double touching = contact_gap(options_.rules, surfaces_.box(), surface.id);
        const double margin = surface.distance - a - touching;
        if (margin < a && !in_contact(b, m, surface.id)) {
          least = std::min(least, margin / contact_tolerance(touching, a));
        }
      }
      const double touching = options_.rules.colloid_gap;
      for (std::size_t other = b + 1; other < bodies.size(); ++other) {
        for (std::size_t om = 0; om < bodies[other].size(); ++om) {
          const double r = norm(shortest(surfaces_.box(), x, bodies[other].position(om)));
          const double margin = r - 2.0 * a - touching;
          if (margin < a &&
              !in_contact(b, m,
                          {SurfaceId::Kind::colloid, bodies[other].members[om].id})) {
            least = std::min(least, margin / contact_tolerance(touching, a));
          }
        }
      }
    }
  }
  return least;
}

// The same between the ends, on the cubic through both: a step may graze a surface.
// Returns the earliest sampled fraction at which something was passed, or 1 if only the
// end counts, or infinity.
double Integrator::event_within(const std::vector<RigidBody>& begin, const Trial& trial,
                                double step) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double at_end = least_event(trial.bodies);
  const double passed = at_end < -1.0 ? 1.0 : kNone;
  double farthest = 0.0;
  for (std::size_t b = 0; b < begin.size(); ++b) {
    for (std::size_t m = 0; m < begin[b].size(); ++m) {
      farthest =
          std::max(farthest, norm(trial.bodies[b].position(m) - begin[b].position(m)));
    }
  }
  // A chord of length s dips below its ends by at most s^2/(8 R), R >= a.
  const double dip = farthest * farthest / (4.0 * options_.radius);
  // In units of the finest tolerance: that of the grains may be below that of colloids.
  const ContactRules& rules = options_.rules;
  const double finest = contact_tolerance(
      std::min({rules.grain_gap, rules.colloid_gap, rules.wall_gap}), options_.radius);
  if (std::min(at_end, least_event(begin)) * finest > dip && passed == kNone) {
    return kNone;
  }
  for (int sample = 1; sample < kSamplesWithin; ++sample) {
    const double t = static_cast<double>(sample) / kSamplesWithin;
    std::vector<RigidBody> at = begin;
    for (std::size_t b = 0; b < begin.size(); ++b) {
      const Vec3 d = trial.bodies[b].centre - begin[b].centre;
      const Vec3 v0 = motion_.velocity[b] * step;
      const Vec3 v1 = trial.end.velocity[b] * step;
      at[b].centre += t * d + (t * (1.0 - t)) * ((1.0 - t) * (v0 - d) - t * (v1 - d));
      for (std::size_t m = 0; m < at[b].arms.size(); ++m) {
        at[b].arms[m] = begin[b].arms[m] * (1.0 - t) + trial.bodies[b].arms[m] * t;
      }
    }
    if (least_event(at) < -1.0) {
      return t;
    }
  }
  return passed;
}

// Finds the step, up to `high`, whose end is at the contact, by the Illinois method.
// After `high` surfaces have passed each other.
bool Integrator::locate(const std::vector<RigidBody>& begin, double high,
                        const std::optional<Forcing>& forcing, Trial& trial,
                        double& step) {
  double f_low = least_event(begin);
  if (f_low <= 0.0) {
    return false;
  }
  Trial end = attempt(begin, high, forcing);
  double f_high = least_event(end.bodies);
  if (f_high >= -1.0) {  // there, or the cubic saw a touch that the step just misses
    trial = std::move(end);
    step = high;
    return true;
  }
  // From here on f_low and f_high are the method's weights, not the functions' values.
  double low = 0.0;
  int side = 0;
  for (int n = 0; n < kMostLocations; ++n) {
    double at = low + (high - low) * f_low / (f_low - f_high);
    // The gap closes fast at first and slowly at last: where interpolation creeps, halve.
    if (n > 10 || !(at > low && at < high)) {
      at = 0.5 * (low + high);
    }
    Trial middle = attempt(begin, at, forcing);
    const double f = least_event(middle.bodies);
    if (std::abs(f) <= 1.0) {
      trial = std::move(middle);
      step = at;
      return true;
    }
    if (f < 0.0) {
      high = at;
      f_high = f;
      f_low = side == -1 ? 0.5 * f_low : f_low;
      side = -1;
    } else {
      low = at;
      f_low = f;
      f_high = side == 1 ? 0.5 * f_high : f_high;
      side = 1;
    }
  }
  throw ConvergenceError("moment of a contact: not found");
}

double Integrator::travel_limit(const Motion& motion,
                                const std::vector<RigidBody>& bodies) const {
  double fastest = 0.0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const Vec3& arm : bodies[b].arms) {
      fastest = std::max(fastest, norm(motion.velocity[b] + cross(motion.spin[b], arm)));
    }
  }
  return fastest > 0.0 ? options_.most_travel * options_.radius / fastest
                       : std::numeric_limits<double>::infinity();
}

void Integrator::count_overlaps(const std::vector<Touch>& touches) {
  const double tolerance = kLeastTolerance * options_.radius;
  for (const Touch& touch : touches) {
    if (touch.gap < -tolerance) {
      ++counts_.overlaps;
      counts_.deepest_overlap = std::max(counts_.deepest_overlap, -touch.gap);
    }
  }
}

double Integrator::advance(std::vector<RigidBody>& bodies, double longest,
                           const std::optional<Forcing>& forcing) {
  assert(!forcing || forcing->step <= longest);  // or it is too weak for the step
  if (bodies.empty()) {
    return longest;
  }
  if (!fresh_) {
    refresh(bodies);
  }
  // Of the motion without thermal forces: a step that depends on the draws would cut off
  // the long ones.
  double step = std::min(longest, travel_limit(motion_, bodies));
  if (forcing) {
    motion_ = evaluate(bodies, forcing);
    step = std::min(step, forcing->step);
  } else if (next_step_ > 0.0) {
    step = std::min(step, next_step_);
  }
  Trial trial;
  for (int rejection = 0;; ++rejection) {
    trial = attempt(bodies, step, forcing);
    const double factor = kSafety * std::pow(std::max(trial.error, 1e-6), -1.0 / 3.0);
    if (forcing || trial.error <= 1.0) {
      // A step cut short by `longest` says little about the next one.
      if (step < longest || factor < 1.0) {
        next_step_ = step * std::clamp(factor, kMostShrink, kMostGrowth);
      } else {
        next_step_ = std::max(next_step_, step);
      }
      break;
    }
    ++counts_.rejected;
    if (!std::isfinite(trial.error) || rejection > kMostRejections) {
      throw ConvergenceError("motion of colloids: no step is short enough");
    }
    step *= std::clamp(factor, kMostShrink, 0.9);
  }
  const double passed = event_within(bodies, trial, step);
  if (std::isfinite(passed)) {
    ++counts_.located;
    if (!locate(bodies, passed * step, forcing, trial, step)) {
      refresh(bodies);
      return 0.0;
    }
  }
  ++counts_.steps;
  bodies = std::move(trial.bodies);
  motion_ = std::move(trial.end);
  // Velocities at the end of the step hold on if nothing there is corrected or new.
  const bool loose = contacts_.empty() && !forcing &&
                     std::all_of(bodies.begin(), bodies.end(), [](const RigidBody& body) {
                       return body.bonds.empty();
                     });
  const std::vector<Touch> touches = settle(bodies);
  count_overlaps(touches);
  if (loose && touches.empty()) {
    take_velocities(bodies);
  } else {
    refresh(bodies, touches);
  }
  return step;
}

// Bonds and pressed contacts keep their distance to the last digit; a surface that this
// pushes another into is pressed then too.  Returns what touches in the end.
std::vector<Touch> Integrator::settle(std::vector<RigidBody>& bodies) {
  std::vector<Contact> pressed;
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    if (motion_.contact_push[c] > 0.0) {
      pressed.push_back(contacts_[c]);
    }
  }
  for (int round = 0;; ++round) {
    keep_distances(bodies, pressed, surfaces_, options_.rules, options_.radius);
    std::vector<Touch> touches =
        find_touches(bodies, surfaces_, options_.rules, options_.radius);
    bool more = false;
    for (const Touch& touch : touches) {
      if (touch.gap < -kLeastTolerance * options_.radius &&
          !sticks(touch, options_.rules, surfaces_.box())) {
        pressed.push_back(touch.contact);
        more = true;
      }
    }
    if (!more || round == kMostRounds) {
      return touches;
    }
  }
}

}  // namespace colloid
