#include "particles/unresolved_gap.h"

#include <algorithm>

#include "core/constants.h"

namespace colloid {

Matrix6 lost_beside(const SurfaceHindrance& hindrance, const NearSurface& surface,
                    double radius, double gap, const SeenGap& seen) {
  const auto at = [&](double width) {
    NearSurface moved = surface;
    moved.distance = radius + width;
    HeldColloid held;
    hindrance.add(moved, 0.0, {}, held);
    return held.resistance;
  };
  Matrix6 found = at(seen.coupling);
  if (seen.force != seen.coupling) {
    found.topLeftCorner<3, 3>() = at(seen.force).topLeftCorner<3, 3>();
  }
  if (seen.torque != seen.coupling) {
    found.bottomRightCorner<3, 3>() = at(seen.torque).bottomRightCorner<3, 3>();
  }
  return at(gap) - found;
}

Matrix6 unresolved_beside(const SurfaceHindrance& hindrance, const NearSurface& surface,
                          double radius, double least_gap, double cell) {
  const double gap = std::max(least_gap, surface.distance - radius);
  if (gap >= kResolvedCells * cell) {
    return Matrix6::Zero();
  }
  const double cells = gap / cell;
  return lost_beside(hindrance, surface, radius, gap,
                     {cell * gap_seen_by_grid(cells), cell * gap_seen_by_turning(cells),
                      cell * gap_seen_by_coupling(cells)});
}

namespace {

// MODEL (R7): wrenches are -mu times this times the motions.  d from sphere 1 to 2.
Matrix12 grand_resistance(const PairResistance& r, double a, double b, const Vector3& d) {
  const Matrix3 along = d * d.transpose();
  const Matrix3 across = Matrix3::Identity() - along;
  const Matrix3 turn = skew(d);  // d x
  const double mean = a + b;
  const auto tensor = [&](double x, double y) { return Matrix3(x * along + y * across); };
  const auto square = [](double x) { return x * x; };
  const auto cube = [](double x) { return x * x * x; };
  Matrix12 out;
  const auto block = [&](Eigen::Index i, Eigen::Index j) {
    return out.block<3, 3>(3 * i, 3 * j);
  };
  // Order of blocks: U_1, w_1, U_2, w_2.
  block(0, 0) = 6.0 * kPi * a * tensor(r.xa11, r.ya11);
  block(0, 2) = 3.0 * kPi * mean * tensor(r.xa12, r.ya12);
  block(2, 2) = 6.0 * kPi * b * tensor(r.xa22, r.ya22);
  block(1, 1) = 8.0 * kPi * cube(a) * tensor(r.xc11, r.yc11);
  block(1, 3) = kPi * cube(mean) * tensor(r.xc12, r.yc12);
  block(3, 3) = 8.0 * kPi * cube(b) * tensor(r.xc22, r.yc22);
  block(0, 1) = 4.0 * kPi * square(a) * r.yb11 * turn;
  block(0, 3) = kPi * square(mean) * r.yb21 * turn;
  block(1, 2) = -kPi * square(mean) * r.yb12 * turn;
  block(2, 3) = 4.0 * kPi * square(b) * r.yb22 * turn;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      block(i, j) = block(j, i).transpose();
    }
  }
  return out;
}

}  // namespace

Matrix12 lost_between(const TwoSphereResistance& pair, const Sphere& one,
                      const Sphere& two, double gap, double seen) {
  const Vec3 apart = two.center - one.center;
  const double mean_radius = 0.5 * (one.radius + two.radius);
  const Vector3 d = eigen(apart) / norm(apart);
  return grand_resistance(pair.at(gap / mean_radius), one.radius, two.radius, d) -
         grand_resistance(pair.at(seen / mean_radius), one.radius, two.radius, d);
}

Matrix12 unresolved_between(const TwoSphereResistance& pair, const Sphere& one,
                            const Sphere& two, double least_gap, double cell) {
  const double gap =
      std::max(least_gap, norm(two.center - one.center) - one.radius - two.radius);
  if (gap >= kResolvedCells * cell) {
    return Matrix12::Zero();
  }
  return lost_between(pair, one, two, gap, cell * gap_seen_by_grid(gap / cell));
}

}  // namespace colloid
