// A sphere held in shear near a wall: see README.md beside this file.
#include <gtest/gtest.h>

#include "shear_case.h"

namespace colloid {
namespace {

TEST(TransientShear, ForceAndTorqueNearAWallAtFiveCells) {
  expect_shear(kNear, 1);
  expect_shear(kFar, 1);
}

TEST(TransientShear, ForceAndTorqueNearAWallAtTenCells) {
  expect_shear(kNear, 2);
  expect_shear(kFar, 2);
}

}  // namespace
}  // namespace colloid
