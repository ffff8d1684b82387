// A sphere that settles at Re 32: see README.md beside this file.
#include <gtest/gtest.h>

#include "settling_case.h"

namespace colloid {
namespace {

TEST(TransientSettling, ReachesThePeakSpeedOfTenCatesE4) {
  expect_fall(kFast, 8);
}

}  // namespace
}  // namespace colloid
