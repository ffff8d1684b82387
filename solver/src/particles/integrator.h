// Steps in time, with error control and located contacts.                 MODEL
// (P11)-(P13)
//
// Runge-Kutta of Bogacki & Shampine (1989), third order with an embedded second.  Errors
// are measured against the colloid's radius, and along the normal of a near surface
// against the gap: a gap that closes against lubrication shrinks by a factor per step.
// A step in which surfaces come to touch, or a colloid passes the outlet, is shortened to
// that moment.  With thermal forces, constant over a step, the same steps are Fixman's
// (1978) midpoint in the sense that they carry the drift kT div M; then the step is given
// and not controlled by errors.
#pragma once

#include <optional>
#include <vector>

#include "particles/contact_rules.h"
#include "particles/motion.h"
#include "particles/surfaces.h"
#include "particles/suspension.h"

namespace colloid {

struct IntegratorOptions {
  double radius = 0.0;       ///< a [m]
  double tolerance = 1e-3;   ///< error per step over a, or over the gap [-]
  double most_travel = 0.5;  ///< per step, over a [-]
  ContactRules rules;
};

/// Counts, for the record.
struct IntegratorCounts {
  long steps = 0;
  long rejected = 0;
  long located = 0;              ///< steps shortened to a contact or a passage
  long evaluations = 0;          ///< of all velocities
  long overlaps = 0;             ///< colloids found overlapping something after a step
  double deepest_overlap = 0.0;  ///< [m]
};

/// Thermal or other wrenches that stay constant for a step of given length.
struct Forcing {
  std::vector<BodyWrench> wrenches;
  double step = 0.0;  ///< [s]
};

/// A pair of surfaces that touch; `contact.other_body` < 0: with something fixed.
struct Touch {
  Contact contact;
  double gap = 0.0;  ///< [m]
};

class Integrator {
 public:
  /// Keeps references.
  Integrator(const IntegratorOptions& options, const MotionModel& model,
             const FixedSurfaces& surfaces);

  /// One step of at most `longest` [s]; returns its length.  Zero: surfaces touch now.
  double advance(std::vector<RigidBody>& bodies, double longest,
                 const std::optional<Forcing>& forcing);

  /// Velocities changed for another reason than a step: the flow, the deposit, the
  /// bodies.  Sets the velocities of the bodies and the contacts.
  void refresh(std::vector<RigidBody>& bodies);

  /// Touching without sticking, now, and with what push.
  const std::vector<Contact>& contacts() const { return contacts_; }
  const Motion& motion() const { return motion_; }

  const IntegratorCounts& counts() const { return counts_; }
  // For checkpoints: the step to try next, and the counts; after refresh().
  double next_step() const { return next_step_; }
  void restore(double next_step, const IntegratorCounts& counts);

 private:
  struct Trial {
    std::vector<RigidBody> bodies;
    Motion end;
    double error = 0.0;  ///< over the tolerance
  };

  Motion evaluate(const std::vector<RigidBody>& bodies,
                  const std::optional<Forcing>& forcing);
  Trial attempt(const std::vector<RigidBody>& bodies, double step,
                const std::optional<Forcing>& forcing);
  double error_of(const std::vector<RigidBody>& bodies, const std::vector<Vec3>& shift,
                  const std::vector<Vec3>& turn) const;
  double least_event(const std::vector<RigidBody>& bodies) const;
  double event_within(const std::vector<RigidBody>& begin, const Trial& trial,
                      double step) const;
  double travel_limit(const Motion& motion, const std::vector<RigidBody>& bodies) const;
  bool locate(const std::vector<RigidBody>& begin, double high,
              const std::optional<Forcing>& forcing, Trial& trial, double& step);
  std::vector<Touch> settle(std::vector<RigidBody>& bodies);
  void take_velocities(std::vector<RigidBody>& bodies) const;
  void count_overlaps(const std::vector<Touch>& touches);
  void refresh(std::vector<RigidBody>& bodies, const std::vector<Touch>& touches);

  IntegratorOptions options_;
  const MotionModel& model_;
  const FixedSurfaces& surfaces_;
  std::vector<Contact> contacts_;
  Motion motion_;
  bool fresh_ = false;  ///< motion_ belongs to the present state
  double next_step_ = 0.0;
  IntegratorCounts counts_;
};

/// All surfaces nearer than the gap of contact and its tolerance, in the order of bodies
/// and members.  Bonds are left out.
std::vector<Touch> find_touches(const std::vector<RigidBody>& bodies,
                                const FixedSurfaces& surfaces, const ContactRules& rules,
                                double radius);

/// Whether the pair sticks by touching alone.
bool sticks(const Touch& touch, const ContactRules& rules, const Box& box);

/// Distance of a point from the plane at which colloids leave, one radius before the
/// nearest outlet [m]; infinite without outlets.
double distance_to_exit(const Box& box, const Vec3& x, double radius);

}  // namespace colloid
