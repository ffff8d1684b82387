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

TEST(TransientRefinementFine, NearAColloidConvergesToRefinementEverywhere) {
  const double fine = refinement_error(20);
  EXPECT_LT(fine, refinement_bound(20));
  // (14/20)^2 = 0.49 of that on the coarser grid, if both are on the way.
  EXPECT_LT(fine, 0.75 * refinement_error(14));
}

TEST(TransientDragFine, OfASimpleCubicArrayAtSixteenAndTwentyCells) {
  expect_array(26);
  expect_array(32);
}

}  // namespace
}  // namespace colloid
