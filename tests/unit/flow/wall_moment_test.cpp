#include "flow/wall_moment.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace colloid {
namespace {

// Midpoint sums over n x n points: second order even across the kink.
double summed(double d, double g1, double g2, int n) {
  double sum = 0.0;
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const double s = (a + 0.5) / n - 0.5;
      const double t = (b + 0.5) / n - 0.5;
      sum += std::max(0.0, d + g1 * s + g2 * t);
    }
  }
  return sum / (n * n);
}

TEST(WallMoment, EqualsTheIntegralInEveryPosition) {
  constexpr int kPoints = 400;
  for (double d : {-0.6, -0.31, -0.05, 0.0, 0.02, 0.27, 0.66}) {
    for (double g1 : {-0.9, -1e-5, 0.0, 0.2, 0.7}) {
      for (double g2 : {-0.4, 0.0, 1e-7, 0.99}) {
        // Each of the points on the kink is off by at most a spacing squared.
        const double tolerance = 2.0 / (kPoints * kPoints);
        EXPECT_NEAR(wall_moment(d, g1, g2), summed(d, g1, g2, kPoints), tolerance)
            << d << " " << g1 << " " << g2;
      }
    }
  }
}

TEST(WallMoment, IsTheDistanceOfAFaceThatThePlaneMisses) {
  EXPECT_EQ(wall_moment(0.71, 0.7, 0.7), 0.71);
  EXPECT_EQ(wall_moment(-0.71, 0.7, 0.7), 0.0);
  EXPECT_EQ(wall_moment(0.1, 0.0, 0.0), 0.1);
  EXPECT_EQ(wall_moment(-0.1, 0.0, 0.0), 0.0);
}

TEST(WallMoment, IsContinuousAndGrowsWithTheDistance) {
  double before = 0.0;
  for (int n = 0; n <= 4000; ++n) {
    const double d = -1.0 + 2.0 * n / 4000;
    const double m = wall_moment(d, 0.6, 0.3);
    EXPECT_GE(m, before - 1e-14);
    EXPECT_LE(m - before, 2.0 / 4000 + 1e-14);  // slope at most 1
    before = m;
  }
}

}  // namespace
}  // namespace colloid
