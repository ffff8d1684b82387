// How much two walls hinder a sphere together: see README.md.
#include "particles/shielding.h"

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "csv_rows.h"
#include "physics/wall_resistance.h"

namespace colloid {
namespace {

WideSurface plane(const Vector3& normal, double height) {
  const WallResistance w = wall_resistance(height - 1.0);
  WideSurface surface;
  surface.normal = normal;
  surface.height = height;
  surface.along = w.f_n;
  surface.across = w.f_t;
  return surface;
}

// Sum of the walls' resistances to motion of the centre.
Matrix3 added(const std::vector<WideSurface>& walls) {
  Matrix3 sum = Matrix3::Identity();
  for (const WideSurface& wall : walls) {
    sum += (wall.across - 1.0) * Matrix3::Identity() +
           (wall.along - wall.across) * wall.normal * wall.normal.transpose();
  }
  return sum;
}

Matrix3 together(const std::vector<WideSurface>& walls) {
  return added(walls) + shielding(walls, Matrix3::Zero(), Vector3::Zero()).resistance;
}

std::vector<WideSurface> corner(double h, double d) {
  return {plane(Vector3::UnitZ(), h), plane(Vector3::UnitX(), d)};
}

TEST(Shielding, OneSurfaceHasNothingToShield) {
  EXPECT_EQ(together({}), added({}));
  const std::vector<WideSurface> single{plane(Vector3::UnitY(), 1.3)};
  EXPECT_LT((together(single) - added(single)).norm(), 1e-12);
}

// A wall ten times as far off as the first one is hardly felt: in a corner what comes
// back from it falls like the cube of the distance instead of the first power (Blake
// 1971), by (h/d)^2 = 1/100, times the squared resistance beside the first wall, below 8
// here.  Of an opposite wall the method shields only what arrives, not what is sent: h/d.
TEST(Shielding, AWallFarBehindAnotherIsNotFelt) {
  const WideSurface near = plane(Vector3::UnitZ(), 1.3);
  for (const auto& [side, part] : {std::pair{Vector3(1.0, 0.0, 0.0), 0.08},
                                   std::pair{Vector3(0.0, 0.0, -1.0), 0.8}}) {
    const WideSurface far = plane(side, 13.0);
    const Matrix3 extra = together({near, far}) - added({near});
    EXPECT_LT(extra.norm(), part * (far.along - 1.0)) << side.transpose();
    EXPECT_GT((added({near, far}) - added({near})).norm(), far.along - 1.0);
  }
}

// Between two planes, along them, halfway: Faxen (1923), 1 - 1.004 x + 0.418 x^3 + 0.21
// x^4 - 0.169 x^5 of the mobility.  The method has the first two coefficients: 1 % of the
// table's 9/8, and 0.5 x^4 for what it leaves out.
TEST(Shielding, HalfwayBetweenPlanesIsWithinItsOrder) {
  for (double height : {4.0, 10.0, 50.0}) {
    const double x = 1.0 / height;
    const double exact = 1.0 / (1.0 - 1.004 * x + 0.418 * std::pow(x, 3) +
                                0.21 * std::pow(x, 4) - 0.169 * std::pow(x, 5));
    const std::vector<WideSurface> slit{plane(Vector3::UnitZ(), height),
                                        plane(-Vector3::UnitZ(), height)};
    EXPECT_NEAR(together(slit)(0, 0), exact,
                (0.0113 * x + 0.5 * std::pow(x, 4)) * exact * exact)
        << height;
  }
}

// The resolved flow on two grids, whose far walls add at most 0.03.  The bounds are the
// accuracy that shielding.h states.
TEST(Shielding, InACornerIsThatOfTheResolvedFlow) {
  int corners = 0;
  for (const auto& row : csv_rows("shielding/corner.csv")) {
    const double h = row[0], d = row[1];
    if (d > 10.0) {
      continue;
    }
    const bool far = d > 2.5 * h;
    double worst_of_sum = 0.0;
    const auto walls = corner(h, d);
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      const double exact = row[2 + at];
      const double of_grid = std::abs(exact - row[5 + at]);
      const double found = together(walls)(axis, axis);
      const double sum = added(walls)(axis, axis);
      std::printf(
          "h %.1f d %.1f axis %d: resolved %.3f +- %.3f, with shielding %.3f, "
          "without %.3f\n",
          h, d, axis, exact, of_grid, found, sum);
      EXPECT_NEAR(found, exact, of_grid + 0.03 + 0.03 * exact);
      worst_of_sum = std::max(worst_of_sum, std::abs(sum / exact - 1.0));
    }
    if (far) {
      EXPECT_GT(worst_of_sum, 0.1);
    }
    ++corners;
  }
  EXPECT_EQ(corners, 5);
}

}  // namespace
}  // namespace colloid
