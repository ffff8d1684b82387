#include "flow/moving_bodies.h"

#include <algorithm>

#include "core/constants.h"

namespace colloid {

BodyBalance free_bodies(const std::vector<MovingBody>& bodies, double viscosity) {
  const auto n = 6 * static_cast<Eigen::Index>(bodies.size());
  BodyBalance balance;
  balance.given = Eigen::VectorXd::Zero(n);
  balance.motions = Eigen::MatrixXd::Identity(n, n);
  balance.load = Eigen::VectorXd::Zero(n);
  balance.guess = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto at = 6 * static_cast<Eigen::Index>(b);
    double reach = 0.0;
    for (const Sphere& sphere : bodies[b].spheres) {
      reach = std::max(reach, norm(sphere.center - bodies[b].centre) + sphere.radius);
    }
    balance.motions.block<3, 3>(at + 3, at + 3) /= reach;
    for (const Sphere& sphere : bodies[b].spheres) {
      const double a = sphere.radius;
      const Vec3 r = sphere.center - bodies[b].centre;
      Eigen::Matrix3d skew;
      skew << 0.0, -r.z, r.y, r.z, 0.0, -r.x, -r.y, r.x, 0.0;
      Eigen::Matrix<double, 3, 6> velocity;  // of the sphere's centre
      velocity << Eigen::Matrix3d::Identity(), -skew;
      auto block = balance.guess.block<6, 6>(at, at);
      block += 6.0 * kPi * viscosity * a * velocity.transpose() * velocity;
      block.bottomRightCorner<3, 3>() +=
          8.0 * kPi * viscosity * a * a * a * Eigen::Matrix3d::Identity();
    }
  }
  return balance;
}

}  // namespace colloid
