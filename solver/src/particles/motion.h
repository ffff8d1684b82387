// What moves colloids, as the time loop sees it.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "particles/small_matrix.h"
#include "particles/surfaces.h"
#include "particles/suspension.h"

namespace colloid {

/// Two surfaces that touch and do not stick: they press on each other or part.
struct Contact {
  int body = -1;
  int member = 0;
  SurfaceId fixed;      ///< unless other_body >= 0
  int other_body = -1;  ///< a mobile one
  int other_member = 0;
};

/// A force and a torque about the centre on a body.
struct BodyWrench {
  Vec3 force;   ///< [N]
  Vec3 torque;  ///< [N m]
};

/// Velocities at one state.
struct Motion {
  std::vector<Vec3> velocity;           ///< of each body's centre [m/s]
  std::vector<Vec3> spin;               ///< [rad/s]
  std::vector<double> contact_push;     ///< normal force of each contact [N], >= 0
  std::vector<BodyWrench> bond_wrench;  ///< of all its bonds on each body
};

using NamedValues = std::vector<std::pair<std::string, double>>;

class MotionModel {
 public:
  MotionModel() = default;
  MotionModel(const MotionModel&) = delete;
  MotionModel& operator=(const MotionModel&) = delete;
  virtual ~MotionModel() = default;

  /// `extra`: wrenches besides those the model knows; empty: none.
  virtual Motion motion(const std::vector<RigidBody>& bodies,
                        const std::vector<Contact>& contacts,
                        const std::vector<BodyWrench>& extra) const = 0;

  /// Thermal wrenches over a step [s], fluctuation balancing dissipation: covariance
  /// 2 kT R / step.  `normals`: six independent normal draws per body.
  virtual std::vector<BodyWrench> thermal_wrenches(const std::vector<RigidBody>& bodies,
                                                   const std::vector<Vector6>& normals,
                                                   double temperature,
                                                   double step) const = 0;

  /// The present state, before a step from it; true if velocities are no longer those of
  /// the last motion().  Models that need nothing but the state have nothing to do.
  virtual bool begin_step(const std::vector<RigidBody>& /*bodies*/,
                          const std::vector<Contact>& /*contacts*/,
                          const Motion& /*motion*/) {
    return false;
  }
  /// How long a step may be that begins now [s].
  virtual double longest_step(const std::vector<RigidBody>& /*bodies*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Colloids that have become fixed, at the state before the next step.
  virtual void deposit_grew(const std::vector<Sphere>& /*deposit*/) {}
  /// What the next motion() depends on besides the bodies; for checkpoints.  restore()
  /// comes after the deposit has grown as it had.
  virtual std::vector<double> state() const { return {}; }
  virtual void restore(const std::vector<double>& /*state*/) {}
  /// Adds what it cost: counts that every run repeats, and seconds, which none does.
  virtual void record(NamedValues& /*counts*/, NamedValues& /*seconds*/) const {}

  /// Wrench on each body if it were held where it is: what bonds have to carry.
  virtual std::vector<BodyWrench> held_wrenches(
      const std::vector<RigidBody>& bodies) const = 0;
};

}  // namespace colloid
