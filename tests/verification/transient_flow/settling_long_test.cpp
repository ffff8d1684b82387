// A sphere that settles at Re 1.5: see README.md beside this file.
#include <gtest/gtest.h>

#include "settling_case.h"

namespace colloid {
namespace {

TEST(TransientSettling, ReachesThePeakSpeedOfTenCatesE1) {
  const Fall found = fall(kSlow, 10, 0.05 * 0.015);
  EXPECT_NEAR(found.peak / kSlow.peak, 1.0, 0.03);
  EXPECT_LT(found.drift, 1e-3 * 0.015);
  EXPECT_EQ(found.rebound, 0.0);
}

}  // namespace
}  // namespace colloid
