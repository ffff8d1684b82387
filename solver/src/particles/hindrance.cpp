#include "particles/hindrance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "physics/wall_resistance.h"

namespace colloid {

namespace {

constexpr double kTurn = 4.0 / 3.0;      // 8 pi mu a^3 over 6 pi mu a^3
constexpr double kSmallestRatio = 0.05;  // of the pair functions
constexpr double kLargestRatio = 20.0;   // beyond: a plane
constexpr double kWeightOne = 0.5 * kHindranceReach;

// What a surface with normal n does: factors along n and across it.
struct Factors {
  double f_n, f_t;  // force of translation
  double t_t;       // coupling, in units of 8 pi mu a^2
  double t_r, t_n;  // torque of rotation across, about n
  double drive_n, drive_t, drive_r;
};

Factors beside_plane(double gap_over_radius) {
  const WallResistance w = wall_resistance(gap_over_radius);
  return {w.f_n, w.f_t, w.t_t, w.t_r, w.t_n, w.f_e, w.f_s, w.t_s};
}

// The pair functions with d = -n and sphere 2 held.
Factors beside_sphere(const PairResistance& r, const StreamDrive& drive) {
  return {r.xa11, r.ya11, -0.5 * r.yb11, r.yc11, r.xc11, drive.n, drive.t, drive.r};
}

void add_factors(const Factors& f, double weight, const Vector3& n,
                 const AmbientMotion& ambient, double radius, HeldColloid& held) {
  const Matrix3 along = n * n.transpose();
  const Matrix3 across = Matrix3::Identity() - along;
  // F gets +4/3 t_t W x n, T gets +4/3 t_t n x U; resistance is minus that.
  const Matrix3 coupling = kTurn * f.t_t * skew(n);
  held.resistance.topLeftCorner<3, 3>() +=
      weight * ((f.f_n - 1.0) * along + (f.f_t - 1.0) * across);
  held.resistance.bottomRightCorner<3, 3>() +=
      weight * kTurn * ((f.t_n - 1.0) * along + (f.t_r - 1.0) * across);
  held.resistance.topRightCorner<3, 3>() += weight * coupling;
  held.resistance.bottomLeftCorner<3, 3>() -= weight * coupling;
  const Vector3 u = eigen(ambient.velocity);
  const Vector3 w = eigen(ambient.spin) * radius;
  held.drive.head<3>() +=
      weight * ((f.drive_n - 1.0) * (along * u) + (f.drive_t - 1.0) * (across * u));
  held.drive.tail<3>() +=
      weight * kTurn * ((f.t_n - 1.0) * (along * w) + (f.drive_r - 1.0) * (across * w));
}

}  // namespace

double hindrance_weight(double gap_over_radius) {
  const double t = std::clamp(
      (kHindranceReach - gap_over_radius) / (kHindranceReach - kWeightOne), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

HeldColloid isolated(const AmbientMotion& ambient, double radius) {
  HeldColloid held;
  held.resistance.diagonal() << 1.0, 1.0, 1.0, kTurn, kTurn, kTurn;
  held.drive << eigen(ambient.velocity), kTurn * radius * eigen(ambient.spin);
  return held;
}

SurfaceHindrance::Neighbour::Neighbour(double ratio) : resistance(ratio), stream(ratio) {}

SurfaceHindrance::SurfaceHindrance(double radius, const std::vector<double>& sphere_radii)
    : radius_(radius) {
  for (double b : sphere_radii) {
    const double ratio = b / radius;
    require(ratio >= kSmallestRatio, "/fidelity/hindrance", [&] {
      return fmt::format(
          "a sphere of diameter {:g} m is smaller than 1/20 of a colloid; "
          "expected \"none\" or larger grains",
          2.0 * b);
    });
    if (ratio <= kLargestRatio) {
      neighbours_.try_emplace(b, ratio);
    }
  }
}

void SurfaceHindrance::add(const NearSurface& surface, double least_gap,
                           const AmbientMotion& ambient, HeldColloid& held) const {
  const double gap = std::max(surface.distance - radius_, least_gap);
  const Vector3 n = eigen(surface.normal);
  if (std::isinf(surface.radius)) {
    add_factors(beside_plane(gap / radius_), 1.0, n, ambient, radius_, held);
    return;
  }
  const double weight = hindrance_weight(gap / radius_);
  if (weight == 0.0) {
    return;
  }
  const auto found = neighbours_.find(surface.radius);
  if (found == neighbours_.end()) {
    add_factors(beside_plane(gap / radius_), weight, n, ambient, radius_, held);
    return;
  }
  const double xi = 2.0 * gap / (radius_ + surface.radius);
  const Neighbour& neighbour = found->second;
  add_factors(beside_sphere(neighbour.resistance.at(xi), neighbour.stream.at(xi)), weight,
              n, ambient, radius_, held);
}

PairHindrance EqualPairHindrance::at(double gap_over_radius) const {
  const double weight = hindrance_weight(gap_over_radius);
  if (weight == 0.0) {
    return {};
  }
  const PairResistance r = resistance_.at(gap_over_radius);
  const StrainHindrance strain = strain_.at(gap_over_radius);
  PairHindrance pair;
  pair.squeeze = weight * (r.xa11 - r.xa12 - 1.0);
  pair.drive = (1.0 - weight * strain.a) * (1.0 + pair.squeeze) - 1.0;
  pair.shear = weight * strain.b;
  return pair;
}

}  // namespace colloid
