// Velocities of rigid bodies free of inertia, subject to bonds and contacts.  MODEL (P7)
//
//     minimise over V:  1/2 V'RV - V'D,   J V = 0 (bonds),   C V >= 0 (contacts)
//
// The motion that dissipates least: R V = D + J' lambda + C' nu, nu >= 0.  Bonds allow
// rolling: the body's point of contact is at rest.  Contacts are free of friction: they
// only keep surfaces from coming nearer.  Units: small_matrix.h.
#pragma once

#include <vector>

#include "particles/small_matrix.h"

namespace colloid {

/// A body by itself.
struct BodySystem {
  Matrix6 resistance = Matrix6::Zero();
  Vector6 drive = Vector6::Zero();
  /// Columns: the motions that the bonds leave.  Identity without bonds; empty: held.
  Eigen::Matrix<double, 6, Eigen::Dynamic> freedom = Matrix6::Identity();
};

/// A row of resistance between two bodies: wrenches -strength row' (row V) and
/// +drive row', with `row` over the motions of both.
struct PairTerm {
  int first = -1;
  int second = -1;
  Vector6 row_first = Vector6::Zero();
  Vector6 row_second = Vector6::Zero();
  double strength = 0.0;
  double drive = 0.0;  ///< [m/s]
};

/// row_first . V_first + row_second . V_second >= 0.
struct ContactRow {
  int first = -1;
  int second = -1;  ///< -1: something fixed
  Vector6 row_first = Vector6::Zero();
  Vector6 row_second = Vector6::Zero();
};

struct BodyMotions {
  std::vector<Vector6> motion;        ///< per body (U, a w)
  std::vector<double> contact_force;  ///< nu per contact row
  std::vector<Vector6> bond_wrench;   ///< J' lambda per body
};

/// Solves group by group: bodies that no pair term or contact joins do not feel each
/// other.  Throws ConvergenceError if a velocity is not finite.
BodyMotions solve_motion(const std::vector<BodySystem>& bodies,
                         const std::vector<PairTerm>& pairs,
                         const std::vector<ContactRow>& contacts);

/// A wrench per body with the covariance of the resistance: L z, R = L L'; `normals` has
/// six independent normal draws per body.
std::vector<Vector6> correlated_wrenches(const std::vector<BodySystem>& bodies,
                                         const std::vector<PairTerm>& pairs,
                                         const std::vector<Vector6>& normals);

/// Motions of a body whose points at `contacts` (from its centre, over the colloid's
/// radius) are at rest.
Eigen::Matrix<double, 6, Eigen::Dynamic> motions_at_rest(
    const std::vector<Vector3>& contacts);

/// Forces at the `contacts` that together make the wrench `load`, of least norm.
std::vector<Vector3> contact_loads(const std::vector<Vector3>& contacts,
                                   const Vector6& load);

}  // namespace colloid
