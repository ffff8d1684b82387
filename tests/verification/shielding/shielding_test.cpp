// How much two walls hinder a sphere together: see README.md.
#include "particles/shielding.h"

#include <cmath>
#include <cstdio>
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

// What a wall B far off, perpendicular to A, takes off the mobility beside A.  Along A, a
// force at the height h moves the liquid far off by 12 h z x_j x_i/r^5 (Blake 1971; over
// 1/(8 pi mu), j the force's direction): the flow of a stresslet of size h in jz.  B
// answers with Blake's image of it; A, where nothing may slip, makes du_j/dz of twice its
// strain, and h du_j/dz is what is felt: k h^2/d^3 with k = 9/2 for j along B's normal,
// 3/2 across it.  B's second answer adds 0.16 and 0.10 of that (far_wall.py), the later
// ones are taken to add no more together.  The next order in h/d counts where the force
// acts and where it is felt.  Along A's normal, the force is felt by two more orders.
TEST(Shielding, AWallFarBehindAnotherIsFeltByTheStressletBesideTheNearOne) {
  const double h = 1.3;
  const WideSurface near = plane(Vector3::UnitZ(), h);
  const double beside_near = 1.0 / (1.0 - 9.0 / 16.0 / h + 0.125 / (h * h * h));
  for (double d : {10.0 * h, 20.0 * h}) {
    const WideSurface far = plane(Vector3::UnitX(), d);
    const Matrix3 extra = together({near, far}) - added({near});
    const double order = 0.75 * h * h / (d * d * d) * beside_near * beside_near;
    const double along = extra(0, 0) / (4.5 * order);
    const double across = extra(1, 1) / (1.5 * order);
    std::printf("d/h %.0f, over B's first answer: %.3f along B's normal, %.3f across\n",
                d / h, along, across);
    EXPECT_GT(along, 1.0 - 2.0 * h / d);
    EXPECT_LT(along, 1.0 + 2.0 * 0.16 + 2.0 * h / d);
    EXPECT_GT(across, 1.0 - 2.0 * h / d);
    EXPECT_LT(across, 1.0 + 2.0 * 0.10 + 2.0 * h / d);
    EXPECT_LT(std::abs(extra(2, 2)), 2.0 * h / d * extra(0, 0));
  }
}

// Mobility along two planes, 1 - c_1 x + c_3 x^3 + ..., halfway and thrice as far from
// one as from the other (Faxen 1923); x: radius over the distance from the nearer one.
double along_slit(double x, double ratio) {
  const std::vector<WideSurface> slit{plane(Vector3::UnitZ(), 1.0 / x),
                                      plane(-Vector3::UnitZ(), ratio / x)};
  return 1.0 / together(slit)(0, 0);
}

struct FaxensSlit {
  double ratio, c1, c3, c4, c5;
};
constexpr FaxensSlit kSlits[] = {{1.0, 1.004, 0.418, 0.21, -0.169},
                                 {3.0, 0.6526, 0.1475, -0.131, -0.0644}};

// The method has c_1 and c_3: 1 % of the table's part of c_1, 9/16 (1 + 1/ratio) less
// c_1, at most as much as the planes' own, and 0.5 x^4 for what it leaves out.
TEST(Shielding, BetweenPlanesIsWithinItsOrder) {
  for (const FaxensSlit& slit : kSlits) {
    for (double x : {0.25, 0.1, 0.02}) {
      const double exact = 1.0 - slit.c1 * x + slit.c3 * std::pow(x, 3) +
                           slit.c4 * std::pow(x, 4) + slit.c5 * std::pow(x, 5);
      const double own = 9.0 / 16.0 * (1.0 + 1.0 / slit.ratio);
      EXPECT_NEAR(along_slit(x, slit.ratio), exact, 0.01 * own * x + 0.5 * std::pow(x, 4))
          << slit.ratio << " " << x;
    }
  }
}

// c_3, the Laplacian of what the planes send back: less its own c_1, and again 0.5 x^4.
TEST(Shielding, BetweenPlanesASphereIsNoPoint) {
  for (const FaxensSlit& slit : kSlits) {
    const double tiny = 2e-3;  // wall_resistance is right to some 1e-9
    const double c1 = (1.0 - along_slit(tiny, slit.ratio)) / tiny;
    for (double x : {0.1, 0.05}) {
      const double c3 = (c1 - (1.0 - along_slit(x, slit.ratio)) / x) / (x * x);
      std::printf("ratio %.0f, x %.2f: c_3 %.4f, exact %.4f\n", slit.ratio, x, c3,
                  slit.c3);
      EXPECT_NEAR(c3, slit.c3, 0.5 * x);
    }
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
