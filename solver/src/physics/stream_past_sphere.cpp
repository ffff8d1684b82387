#include "physics/stream_past_sphere.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/error.h"
#include "physics/two_sphere_series.h"

namespace colloid {

namespace {

constexpr int kDegree = 40;

/// Coefficients of (-u)^m from those of u^m.
std::vector<double> alternating(std::vector<double> coefficients) {
  for (std::size_t m = 1; m < coefficients.size(); m += 2) {
    coefficients[m] = -coefficients[m];
  }
  return coefficients;
}

/// Both spheres held: the prefactors of the functions 11 and 12, MODEL (R7), are such
/// that the even and the odd terms of a series add up to the one series in -u.
ChebyshevSeries<3> drive_against_u(double ratio) {
  require(ratio >= 0.05 && ratio <= 20.0, "stream past a sphere",
          "the ratio of the radii must be in [0.05, 20]; beyond, one is a wall");
  const TwoSphereSeries series = two_sphere_recurrences().series(ratio);
  const std::vector<double> along = alternating(series.xa);
  const std::vector<double> across = alternating(series.ya);
  // The torque begins with u^2, as the vorticity does.
  std::vector<double> torque = alternating(series.yb);
  torque.erase(torque.begin(), torque.begin() + 2);
  const double sum = 1.0 + ratio;
  const double torque_over_spin = -2.0 * sum * sum / (3.0 * ratio);
  return ChebyshevSeries<3>(kDegree, [&](double u) {
    const double v = u / sum;  // a/r
    const double stokeslet = ratio * v;
    const double dipole = ratio * (ratio * ratio + 1.0) * v * v * v;
    return std::array<double, 3>{
        sum_without_lubrication(along, u) / (1.0 - 1.5 * stokeslet + 0.5 * dipole),
        sum_without_lubrication(across, u) / (1.0 - 0.75 * stokeslet - 0.25 * dipole),
        sum_without_lubrication(torque, u) * torque_over_spin};
  });
}

}  // namespace

FaxenPastSphere faxen_past_sphere(double ratio, double distance) {
  const double b = ratio;
  const double r = distance;
  // (a^2/6) lap of the velocity and (a^2/10) lap of its gradient have the form of the
  // dipole's term.
  return {1.0 - 0.75 * b / r - 0.25 * (b * b * b + b) / (r * r * r), 0.75 * b / (r * r),
          0.75 * (b * b * b + 0.6 * b) / (r * r * r * r)};
}

StreamPastSphere::StreamPastSphere(double ratio) : drive_(drive_against_u(ratio)) {}

StreamDrive StreamPastSphere::at(double gap) const {
  const auto drive = drive_.at(2.0 / (2.0 + gap));
  return {drive[0], drive[1], drive[2]};
}

}  // namespace colloid
