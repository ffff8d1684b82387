#include "tiers/transient/rigid.h"

namespace colloid {

SixBySix motion_products(const Vec3& arm) {
  Eigen::Matrix<double, 3, 6> z = Eigen::Matrix<double, 3, 6>::Zero();
  z.leftCols<3>().setIdentity();
  // W x arm = -[arm]x W
  z.rightCols<3>() << 0.0, arm.z, -arm.y, -arm.z, 0.0, arm.x, arm.y, -arm.x, 0.0;
  return z.transpose() * z;
}

SixBySix sphere_inertia(double mass, double radius) {
  SixBySix m = SixBySix::Zero();
  m.diagonal() << mass, mass, mass, 0.4 * mass * radius * radius,
      0.4 * mass * radius * radius, 0.4 * mass * radius * radius;
  return m;
}

}  // namespace colloid
