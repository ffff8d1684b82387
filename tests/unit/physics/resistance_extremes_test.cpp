// Resistance factors over all gaps that a run meets: finite, and monotonic where a
// smaller gap can only hinder more.  The table on standard output is the one in
// results/evidence/extremes.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "physics/pair_resistance.h"
#include "physics/wall_resistance.h"

namespace colloid {
namespace {

TEST(ResistanceExtremes, WallHindersMoreTheNearerItIs) {
  std::printf(
      "gap/a      f_n        f_t     t_t       t_r     f_s     t_s     t_n   "
      "U/(S(a+h))\n");
  WallResistance farther = wall_resistance(1e6);
  double faster = 1.0;
  for (double gap : {10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
    const WallResistance r = wall_resistance(gap);
    const double speed = free_in_shear(gap).speed;
    EXPECT_GT(r.f_n, farther.f_n);
    EXPECT_GT(r.f_t, farther.f_t);
    EXPECT_GT(r.t_t, farther.t_t);
    EXPECT_GT(r.t_r, farther.t_r);
    EXPECT_GT(r.f_s, farther.f_s);
    EXPECT_LT(r.t_s, farther.t_s);
    EXPECT_GT(r.t_n, farther.t_n);
    EXPECT_LT(speed, faster);
    farther = r;
    faster = speed;
    std::printf("%-8g %10.4g %8.4f %8.5f %8.4f %7.4f %7.4f %7.4f %8.4f\n", gap, r.f_n,
                r.f_t, r.t_t, r.t_r, r.f_s, r.t_s, r.t_n, speed);
  }
}

TEST(ResistanceExtremes, EqualSpheresHinderMoreTheNearerTheyAre) {
  std::printf("gap/a    xa11-xa12  ya11-ya12  yb11-yb12  yc11-yc12    xc11-xc12\n");
  const TwoSphereResistance resistance(1.0);
  double squeeze = 1.0;
  double shear = 1.0;
  for (double gap : {10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
    const PairResistance r = resistance.at(gap);
    EXPECT_GT(r.xa11 - r.xa12, squeeze);
    EXPECT_GT(r.ya11 - r.ya12, shear);
    squeeze = r.xa11 - r.xa12;
    shear = r.ya11 - r.ya12;
    std::printf("%-8g %10.5g %10.5f %10.5f %10.5f %10.5f\n", gap, squeeze, shear,
                r.yb11 - r.yb12, r.yc11 - r.yc12, r.xc11 - r.xc12);
    EXPECT_TRUE(std::isfinite(r.yb11) && std::isfinite(r.yc11) && std::isfinite(r.xc11));
  }
}

}  // namespace
}  // namespace colloid
