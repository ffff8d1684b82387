// Refined near a colloid or everywhere: see README.md beside this file.
#include <gtest/gtest.h>

#include "refinement_case.h"

namespace colloid {
namespace {

TEST(TransientRefinement, NearAColloidGivesTheDragOfRefinementEverywhere) {
  EXPECT_LT(refinement_error(14, 0), refinement_bound(14));
}

// Nearly all of that is the grains' surfaces.  Refined too, what is left is the smooth
// flow between, less than the 1 % by which the drag depends on the place in the grid.
TEST(TransientRefinement, AtGrainsTooLeavesNoDifference) {
  EXPECT_LT(refinement_error(14, 1), 0.01);
}

}  // namespace
}  // namespace colloid
