// Bonds between colloids: springs along, across and (rigid ones) about the line of
// centres, damped.                                                       MODEL (T-D6)
#pragma once

#include <cstdint>

#include "core/vec3.h"
#include "tiers/transient/dem.h"

namespace colloid {

struct BondStiffness {
  double normal = 0.0;  ///< k [N/m]
  double across = 0.0;  ///< [N/m]
  double about = 0.0;   ///< [N m], rigid bonds
  // Damping: a fixed part of the critical.
  double normal_damping = 0.0;  ///< [N s/m]
  double across_damping = 0.0;  ///< [N s/m]
  double about_damping = 0.0;   ///< [N m s]
};

/// k: Hertz' stiffness at the overlap where two colloids repel with their pull-off.
BondStiffness bond_stiffness(const DemOptions& options);

/// Longest stable sub-step [s] of a cluster in which every colloid has twelve bonds.
double longest_bond_step(const DemOptions& options);

/// Plain: is saved as bytes.
struct Bond {
  std::int32_t first = -1;  ///< ids
  std::int32_t second = -1;
  std::int32_t rigid = 0;
  std::int32_t broken = 0;
  double length = 0.0;  ///< between the centres, when it was made [m]
  Vec3 across;          ///< displacement at the contact [m]
  Vec3 about;           ///< relative rotation [rad], rigid bonds
  double tension = 0.0;
  double largest_tension = 0.0;
};

struct BondEnd {
  Vec3 velocity, spin;
};

struct BondForce {
  Vec3 force;  ///< on the first; the second's is opposite
  Vec3 first_torque;
  Vec3 second_torque;
};

/// `offset`: from the second's centre to the first's.  `step` 0: does not move the
/// history on.
BondForce bond_force(Bond& bond, const BondStiffness& stiffness, const Vec3& offset,
                     const BondEnd& first, const BondEnd& second, double step);

}  // namespace colloid
