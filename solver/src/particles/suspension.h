// The mobile colloids and the rigid bodies that they form.
//
// A body is one colloid, or several that touched and move as one.  It may be tied to
// retained colloids by bonds, on which it rolls: bonded, but still mobile.
#pragma once

#include <limits>
#include <vector>

#include "particles/small_matrix.h"
#include "particles/surfaces.h"

namespace colloid {

struct MobileColloid {
  int id = -1;
  double injection_time = 0.0;  ///< [s]
  Vec3 injection_position;      ///< [m]
  /// First touch with what holds it now; not a number if free [s].
  double contact_time = std::numeric_limits<double>::quiet_NaN();
  double expected_escapes = 0.0;  ///< over the barrier of the grain it rests on, so far
};

/// A place where a body touches something fixed and sticks to it.
struct Bond {
  int member = 0;         ///< of the body
  SurfaceId fixed;        ///< a retained colloid
  Vec3 anchor;            ///< its centre [m]
  double distance = 0.0;  ///< of the two centres, kept [m]
};

struct RigidBody {
  std::vector<MobileColloid> members;
  Vec3 centre;             ///< mean of the members' centres [m]
  std::vector<Vec3> arms;  ///< from `centre` to each member's centre [m]
  std::vector<Bond> bonds;
  Vec3 velocity;  ///< of `centre`, at the last accepted state [m/s]
  Vec3 spin;      ///< [rad/s]
  // Since when it has been slow, and where it was then: a body that stays slow and near
  // for long enough is at rest.
  double slow_since = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  Vec3 slow_at;                                                  ///< [m]

  bool bonded() const { return !bonds.empty(); }            ///< to the deposit
  bool attached() const { return bonded() || size() > 1; }  ///< to any colloid
  bool bonded_to(std::size_t member, const SurfaceId& fixed) const;
  std::size_t size() const { return members.size(); }
  Vec3 position(std::size_t member) const { return centre + arms[member]; }
  Vec3 velocity_of(std::size_t member) const {
    return velocity + cross(spin, arms[member]);
  }
};

RigidBody single(const MobileColloid& colloid, const Vec3& position);

/// Two bodies that touch become one.  Members and bonds of `a` come first.  `shift`
/// brings `b` next to `a` through periodic faces [m].
RigidBody joined(const RigidBody& a, const RigidBody& b, const Vec3& shift);

/// The body without one member, whose bonds go with it.
RigidBody without(const RigidBody& body, std::size_t member);

/// Moves the body by `step` [m] and turns it by the rotation vector `turn` [rad].
void displace(RigidBody& body, const Vec3& step, const Vec3& turn);

/// Where the contact of a bond is, from the body's centre [m].
Vec3 bond_contact(const RigidBody& body, const Bond& bond, const Box& box, double radius);
/// Those of all its bonds, over the colloid's radius.
std::vector<Vector3> bond_contacts(const RigidBody& body, const Box& box, double radius);

/// Row that gives the velocity of a member's surface along n, of a motion (U, a w) of the
/// body; likewise the wrench (F, T/a) of a unit force along n there.
Vector6 normal_row(const RigidBody& body, std::size_t member, const Vec3& n,
                   double radius);

/// v turned by the rotation vector (Rodrigues' formula).
Vec3 turned(const Vec3& v, const Vec3& turn);

}  // namespace colloid
