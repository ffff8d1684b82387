// Finer grids of the cases beside: see README.md beside this file.
#include <gtest/gtest.h>

#include "array_case.h"
#include "refinement_case.h"
#include "shear_case.h"

namespace colloid {
namespace {

TEST(TransientShearFine, ForceAndTorqueNearAWallAtTwentyCells) {
  expect_shear(kNear, 3);
  expect_shear(kFar, 3);
}

TEST(TransientRefinementFine, NearAColloidGivesTheDragOfRefinementEverywhere) {
  EXPECT_LT(refinement_error(20, 0), refinement_bound(20));
  EXPECT_LT(refinement_error(20, 1), 0.01);
}

TEST(TransientDragFine, OfASimpleCubicArrayAtSixteenAndTwentyCells) {
  expect_array(26);
  expect_array(32);
}

}  // namespace
}  // namespace colloid
