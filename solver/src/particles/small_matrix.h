// Six-vectors and matrices of rigid motion, in common units.
//
// Motion (U, a w): velocity [m/s] and angular velocity times the colloid's radius [m/s].
// Wrench (F, T/a) / (6 pi mu a): also [m/s].  So an isolated sphere has the resistance
// diag(1, 1, 1, 4/3, 4/3, 4/3).
#pragma once

#include <Eigen/Dense>

#include "core/vec3.h"

namespace colloid {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;  ///< of two bodies

inline Vector3 eigen(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline Vec3 plain(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// [v]x, so that skew(v) w = v x w.
inline Matrix3 skew(const Vector3& v) {
  Matrix3 m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace colloid
