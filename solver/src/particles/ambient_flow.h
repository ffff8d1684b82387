// The flow that carries a colloid, as if the colloid were not there.
#pragma once

#include "particles/small_matrix.h"

namespace colloid {

/// Motion of the liquid averaged over a colloid's surface: what a sphere free of force
/// and torque takes on by Faxen's laws.                                         MODEL
/// (P1)
struct AmbientMotion {
  Vec3 velocity;                     ///< [m/s]
  Vec3 spin;                         ///< angular velocity, half the vorticity [rad/s]
  Matrix3 strain = Matrix3::Zero();  ///< rate of strain [1/s]
};

class AmbientFlow {
 public:
  AmbientFlow() = default;
  AmbientFlow(const AmbientFlow&) = delete;
  AmbientFlow& operator=(const AmbientFlow&) = delete;
  virtual ~AmbientFlow() = default;

  /// Around a sphere of `radius` [m] at `centre` [m].
  virtual AmbientMotion around(const Vec3& centre, double radius) const = 0;
};

}  // namespace colloid
