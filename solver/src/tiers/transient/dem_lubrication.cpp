#include "tiers/transient/dem_lubrication.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "particles/unresolved_gap.h"

namespace colloid {

namespace {

constexpr double kTolerance = 1e-10;  // of the largest force
constexpr int kSweeps = 20000;
constexpr double kSmallestRatio = 0.05;  // of radii for which there are functions

// (T9), measured by tests/verification/transient_lubrication.
struct Point {
  double gap, resistance;
};
constexpr std::array<Point, 13> kResolved{{{0.0, 1.65},
                                           {0.1, 1.59},
                                           {0.2, 1.49},
                                           {0.3, 1.405},
                                           {0.4, 1.32},
                                           {0.5, 1.225},
                                           {0.6, 1.17},
                                           {0.8, 1.01},
                                           {1.0, 0.86},
                                           {1.25, 0.70},
                                           {1.5, 0.593},
                                           {2.0, 0.466},
                                           {3.0, 1.0 / 3.0}}};

constexpr double kSlidingRange = 0.5;  // of (T10), the same [cells]

}  // namespace

double resolved_resistance(double x) {
  if (x >= kResolvedGap) {
    return 1.0 / x;
  }
  const auto* above = std::find_if(kResolved.begin(), kResolved.end() - 1,
                                   [&](const Point& p) { return p.gap > x; });
  const auto* below = above - 1;
  const double part = (x - below->gap) / (above->gap - below->gap);
  return std::min(1.0 / x,
                  below->resistance + part * (above->resistance - below->resistance));
}

double gap_seen_by_sliding(double x, double closed) {
  return x + closed * std::exp(-x / kSlidingRange);
}

double lubrication_resistance(double viscosity, double reduced_radius, double gap,
                              double cell, double floor) {
  const double h = std::max(gap, floor);
  return 6.0 * kPi * viscosity * reduced_radius * reduced_radius *
         std::max(0.0, 1.0 / h - resolved_resistance(h / cell) / cell);
}

namespace {

const std::vector<double>& not_narrow(double radius,
                                      const std::vector<double>& grain_radii) {
  for (const double b : grain_radii) {
    require(b >= kSmallestRatio * radius, "/fidelity/lubrication", [&] {
      return fmt::format(
          "is full, but a grain of diameter {:g} m is smaller than 1/20 of a colloid; "
          "expected larger grains, or \"resolved_only\"",
          2.0 * b);
    });
  }
  return grain_radii;
}

}  // namespace

GapResistance::GapResistance(double viscosity, double radius,
                             const std::vector<double>& grain_radii, double cell,
                             double floor)
    : viscosity_(viscosity),
      radius_(radius),
      cell_(cell),
      floor_(floor),
      surfaces_(radius, not_narrow(radius, grain_radii)),
      colloids_(1.0) {}

double GapResistance::along(double reduced_radius, double gap) const {
  return lubrication_resistance(viscosity_, reduced_radius, gap, cell_, floor_);
}

double GapResistance::seen(double gap, double closed) const {
  return cell_ * gap_seen_by_sliding(gap / cell_, closed);
}

Matrix6 GapResistance::beside(const NearSurface& surface) const {
  const double a = radius_;
  const double gap = std::max(floor_, surface.distance - a);
  const bool plane = std::isinf(surface.radius);
  const double seen_gap = seen(gap, plane ? kSeenBesidePlane : kSeenBesideSphere);
  Matrix6 out = 6.0 * kPi * viscosity_ * a *
                lost_beside(surfaces_, surface, a, gap, {seen_gap, seen_gap, seen_gap});
  const Vector3 n = eigen(surface.normal);
  const Matrix3 across = Matrix3::Identity() - n * n.transpose();
  const double reduced = plane ? a : a * surface.radius / (a + surface.radius);
  out.topLeftCorner<3, 3>() = across * out.topLeftCorner<3, 3>() * across +
                              along(reduced, gap) * n * n.transpose();
  return out;
}

Matrix12 GapResistance::between(const Vec3& offset) const {
  const double a = radius_;
  const double gap = std::max(floor_, norm(offset) - 2.0 * a);
  Matrix6 units = Matrix6::Identity();  // from (v, a w) to (v, w)
  units.diagonal().tail<3>().setConstant(1.0 / a);
  const Matrix12 lost = viscosity_ * lost_between(colloids_, {{}, a}, {-offset, a}, gap,
                                                  seen(gap, kSeenBesideSphere));
  const Vector3 n = eigen(offset) / norm(offset);
  const Matrix3 across = Matrix3::Identity() - n * n.transpose();
  const Matrix3 approach = along(0.5 * a, gap) * n * n.transpose();
  Matrix12 out;
  for (const int i : {0, 6}) {
    for (const int j : {0, 6}) {
      out.block<6, 6>(i, j) = units * lost.block<6, 6>(i, j) * units;
      out.block<3, 3>(i, j) =
          across * out.block<3, 3>(i, j) * across + (i == j ? 1.0 : -1.0) * approach;
    }
  }
  return out;
}

NarrowGap narrow_gap(int colloid, const Matrix6& resistance) {
  NarrowGap gap;
  gap.first = colloid;
  gap.resistance.setZero();
  gap.resistance.topLeftCorner<6, 6>() = resistance;
  gap.drive.setZero();
  return gap;
}

NarrowGap narrow_gap(int first, int second, const Matrix12& resistance) {
  NarrowGap gap;
  gap.first = first;
  gap.second = second;
  gap.pair = true;
  gap.resistance = resistance;
  gap.drive.setZero();
  return gap;
}

namespace {

// The matrices of one gap: of one colloid or two.
using GapMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 12, 12>;
using GapVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 12, 1>;

// What the wrench of a gap changes by, per what its law misses: (1 + R C)^-1.
GapMatrix answer_of(const NarrowGap& gap, const GapVector& compliance) {
  const Eigen::Index n = compliance.size();
  return (GapMatrix::Identity(n, n) +
          gap.resistance.topLeftCorner(n, n) * compliance.asDiagonal())
      .inverse();
}

GapVector of_both(const NarrowGap& gap, const std::vector<Vector6>& of) {
  GapVector out = GapVector::Zero(gap.pair ? 12 : 6);
  if (gap.first >= 0) {
    out.head<6>() = of[static_cast<std::size_t>(gap.first)];
  }
  if (gap.second >= 0) {
    out.segment<6>(6) = of[static_cast<std::size_t>(gap.second)];
  }
  return out;
}

}  // namespace

void solve_lubrication(std::vector<NarrowGap>& gaps,
                       const std::vector<Vector6>& compliance,
                       std::vector<Vector6>& motion) {
  struct Share {
    GapVector compliance;
    GapMatrix answer;
  };
  std::vector<Share> shares;
  for (NarrowGap& gap : gaps) {
    gap.wrench.setZero();
    const GapVector own = of_both(gap, compliance);
    shares.push_back({own, answer_of(gap, own)});
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double largest = 0.0;
    double change = 0.0;
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      NarrowGap& gap = gaps[g];
      const auto n = shares[g].compliance.size();
      const GapVector more =
          shares[g].answer *
          (gap.drive.head(n) - gap.resistance.topLeftCorner(n, n) * of_both(gap, motion) -
           gap.wrench.head(n));
      gap.wrench.head(n) += more;
      const GapVector moved = shares[g].compliance.cwiseProduct(more);
      if (gap.first >= 0) {
        motion[static_cast<std::size_t>(gap.first)] += moved.head<6>();
      }
      if (gap.second >= 0) {
        motion[static_cast<std::size_t>(gap.second)] += moved.segment<6>(6);
      }
      largest = std::max(largest, gap.wrench.cwiseAbs().maxCoeff());
      change = std::max(change, more.cwiseAbs().maxCoeff());
    }
    if (gaps.size() == 1 || change <= kTolerance * largest) {
      return;
    }
  }
  throw ConvergenceError("DEM: the lubrication forces between colloids do not converge");
}

}  // namespace colloid
