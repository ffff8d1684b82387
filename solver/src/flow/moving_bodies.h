// Rigid bodies that the flow carries, as the flow solver is asked.  SI.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/box.h"

namespace colloid {

/// Spheres that move as one: velocity U + w x (x - centre).
struct MovingBody {
  Vec3 centre;                  ///< torques and U refer to it [m]
  std::vector<Sphere> spheres;  ///< no slip; may touch
};

/// The balances of n bodies, without inertia.  Vectors of 6 n: per body (U [m/s],
/// w [rad/s]), or (force [N], torque about its centre [N m]).
///
///     V = given + motions q,     motions' (H(V) + load - resistance V) = 0
///
/// H the wrenches of the fluid.  Bodies that are moved have no columns in `motions`, free
/// ones six, bonds leave fewer.  The residual of a solve weighs q alike: a column for a
/// spin must not be one of 1 rad/s but of surfaces that move like the others, at 1 m/s.
struct BodyBalance {
  Eigen::VectorXd given;
  Eigen::MatrixXd motions;     ///< 6 n x m
  Eigen::MatrixXd resistance;  ///< besides the resolved flow's; zero: empty
  Eigen::VectorXd load;
  /// About -dH/dV, positive definite: speeds up the solve, does not change its result.
  Eigen::MatrixXd guess;
};

/// Force-free bodies, or with `load`; the guess is Stokes' for isolated spheres, spins
/// are counted by the fastest point of a body.
BodyBalance free_bodies(const std::vector<MovingBody>& bodies, double viscosity);

}  // namespace colloid
