// A sphere that settles at Re 32: see README.md beside this file.
#include <gtest/gtest.h>

#include "settling_case.h"

namespace colloid {
namespace {

TEST(TransientSettling, ReachesThePeakSpeedOfTenCatesE4) {
  const Fall found = fall(kFast, 8, 0.05 * 0.015);
  EXPECT_NEAR(found.peak / kFast.peak, 1.0, 0.03);
  EXPECT_LT(found.drift, 1e-3 * 0.015);
  EXPECT_EQ(found.rebound, 0.0);
}

}  // namespace
}  // namespace colloid
