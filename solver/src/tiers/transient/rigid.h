// The rigid motion of free bodies as unknowns of the fluid's linear systems.
//                                                                        MODEL section T
//
// Per body six unknowns q = (U, W).  Entries tie cells to bodies (immersed.h);
// eliminating q leaves the fluid's own system plus one term of rank six per free body,
// which a Krylov method applies as it is.
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "tiers/transient/immersed.h"
#include "tiers/transient/transient_flow.h"

namespace colloid {

using Six = Eigen::Matrix<double, 6, 1>;
using SixBySix = Eigen::Matrix<double, 6, 6>;

/// Velocity at `arm` of the motion q = (U, W).
inline Vec3 rigid_velocity(const Six& q, const Vec3& arm) {
  return Vec3{q[0], q[1], q[2]} + cross({q[3], q[4], q[5]}, arm);
}
/// (f, arm x f): its transpose.
inline Six wrench(const Vec3& f, const Vec3& arm) {
  const Vec3 t = cross(arm, f);
  Six out;
  out << f.x, f.y, f.z, t.x, t.y, t.z;
  return out;
}
/// Z^T Z of one cell.
SixBySix motion_products(const Vec3& arm);

/// diag(m, m, m, I, I, I) of a solid sphere of mass m and radius a.
SixBySix sphere_inertia(double mass, double radius);

}  // namespace colloid
