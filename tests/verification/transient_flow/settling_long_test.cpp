// A sphere that settles at Re 1.5: see README.md beside this file.
#include <gtest/gtest.h>

#include "settling_case.h"

namespace colloid {
namespace {

TEST(TransientSettling, ReachesThePeakSpeedOfTenCatesE1) {
  expect_fall(kSlow, 10);
}

}  // namespace
}  // namespace colloid
