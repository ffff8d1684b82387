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
// A sphere so wide that its tangent plane stands for it in what surfaces shield each
// other from.
constexpr double kWideRatio = 2.0;

// What a surface with normal n does: factors along n and across it.
struct Factors {
  double f_n, f_t;  // force of translation
  double t_t;       // coupling, in units of 8 pi mu a^2
  double t_r, t_n;  // torque of rotation across, about n
  double drive_n;   // of the flow along n
  // Force and torque per strain across n over a, of a flow that does not slip on the
  // surface, beyond those of its velocity and spin.
  double strain_force, strain_torque;
  // Of a stream past the surface.  Beside a narrow sphere the flow's own strain is not
  // its doing alone, and that of the stream with the flow's velocity takes its place.
  double strain_by_velocity;
  // Along n: strain over velocity, Faxen's, of the flow that drive_n belongs to.
  double strain_along_by_velocity;
  bool wide;  // like a plane to what it shields
};

Factors beside_plane(double gap_over_radius) {
  const WallResistance w = wall_resistance(gap_over_radius);
  const double h = 1.0 + gap_over_radius;  // of the centre
  // In the shear u_x = S z: velocity S h, spin and strain S/2.
  return {w.f_n,
          w.f_t,
          w.t_t,
          w.t_r,
          w.t_n,
          w.f_e,
          2.0 * h * (w.f_s - w.f_t) + kTurn * w.t_t,
          kTurn * (w.t_s - w.t_r + 2.0 * h * w.t_t),
          0.5 / h,
          2.0 * h / (h * h + 1.0 / 3.0),
          true};
}

// Of the stream past a sphere `ratio` times as wide, averaged over the colloid's surface
// (Faxen 1922), on the axis: strain over velocity, lengths over a.
double strain_along_by_velocity(double ratio, double distance) {
  const double s = ratio / distance;
  const double per_square = s / (distance * distance);
  const double velocity = 1.0 - 1.5 * s + 0.5 * s * s * s + 0.5 * per_square;
  const double strain = (1.5 * s * (1.0 - s * s) - 0.9 * per_square) / distance;
  return strain / velocity;
}

// Force along the normal on a sphere held beside a plane, at the height h of its centre,
// by strain beyond that of the stagnation flow with the same velocity: exact for any
// mixture of the flows u_z = z^2 and z^3 (tables/cubic_flow.py), within 1e-4 of itself.
double excess_coefficient(double h) {
  const double x = 1.0 / h;
  return -15.0 / 16.0 * x * x *
         (1.0 + x * (9.0 / 8.0 +
                     x * (-0.7003 +
                          x * (-0.1898 + x * (2.2490 + x * (-2.2434 + x * 0.5573))))));
}

// The pair functions with d = -n and sphere 2, `ratio` times as wide, held.
Factors beside_sphere(const PairResistance& r, const StreamDrive& drive, double ratio,
                      double gap_over_radius) {
  const double t_t = -0.5 * r.yb11;
  // In a stream past the surface.
  const FaxenPastSphere flow = faxen_past_sphere(ratio, 1.0 + ratio + gap_over_radius);
  const double force = (drive.t - r.ya11) * flow.velocity + kTurn * t_t * flow.spin;
  const double torque = kTurn * ((drive.r - r.yc11) * flow.spin + t_t * flow.velocity);
  return {r.xa11,
          r.ya11,
          t_t,
          r.yc11,
          r.xc11,
          drive.n,
          force / flow.strain,
          torque / flow.strain,
          flow.strain / flow.velocity,
          strain_along_by_velocity(ratio, 1.0 + ratio + gap_over_radius),
          ratio >= kWideRatio};
}

void add_factors(const Factors& f, double weight, double height, const Vector3& n,
                 const AmbientMotion& ambient, double radius, HeldColloid& held) {
  const Matrix3 along = n * n.transpose();
  const Matrix3 across = Matrix3::Identity() - along;
  // F gets +4/3 t_t W x n, T gets +4/3 t_t n x U; resistance is minus that.
  const Matrix3 coupling = kTurn * f.t_t * skew(n);
  Matrix6 resistance;
  resistance << (f.f_n - 1.0) * along + (f.f_t - 1.0) * across, coupling, -coupling,
      kTurn * ((f.t_n - 1.0) * along + (f.t_r - 1.0) * across);
  held.resistance += weight * resistance;
  if (f.wide) {
    held.wide.push_back(
        {n, height, 1.0 + weight * (f.f_n - 1.0), 1.0 + weight * (f.f_t - 1.0),
         (f.drive_n / f.f_n - 1.0) / f.strain_along_by_velocity, f.strain_force / f.f_t,
         f.strain_along_by_velocity, excess_coefficient(height), weight});
  }
  const Vector3 velocity = eigen(ambient.velocity);
  const Vector3 strain = f.wide ? Vector3(radius * (across * (ambient.strain * n)))
                                : Vector3(f.strain_by_velocity * (across * velocity));
  Vector6 beyond;
  beyond << (f.drive_n - f.f_n) * (along * velocity) + f.strain_force * strain,
      f.strain_torque * n.cross(strain);
  held.drive += weight * beyond;
}

}  // namespace

double hindrance_weight(double gap_over_radius) {
  const double t = std::clamp(
      (kHindranceReach - gap_over_radius) / (kHindranceReach - kWeightOne), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

HeldColloid isolated() {
  HeldColloid held;
  held.resistance.diagonal() << 1.0, 1.0, 1.0, kTurn, kTurn, kTurn;
  return held;
}

void let_shield_and_carry(const AmbientMotion& ambient, double radius,
                          HeldColloid& held) {
  const Shielding together =
      shielding(held.wide, radius * ambient.strain, eigen(ambient.velocity));
  held.resistance.topLeftCorner<3, 3>() += together.resistance;
  held.drive.head<3>() += together.drive;
  Vector6 carried;
  carried << eigen(ambient.velocity), radius * eigen(ambient.spin);
  held.drive += held.resistance * carried;
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
  const double gap = std::max(surface.distance - radius_, least_gap) / radius_;
  const bool plane = std::isinf(surface.radius);
  const double weight = plane ? 1.0 : hindrance_weight(gap);
  if (weight == 0.0) {
    return;
  }
  const auto found = plane ? neighbours_.end() : neighbours_.find(surface.radius);
  Factors factors{};
  if (found == neighbours_.end()) {
    factors = beside_plane(gap);
  } else {
    const double ratio = surface.radius / radius_;
    const double xi = 2.0 * gap / (1.0 + ratio);
    factors = beside_sphere(found->second.resistance.at(xi), found->second.stream.at(xi),
                            ratio, gap);
  }
  add_factors(factors, weight, 1.0 + gap, eigen(surface.normal), ambient, radius_, held);
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
