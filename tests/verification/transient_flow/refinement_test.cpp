// Refined near a colloid or everywhere: see README.md beside this file.
#include <gtest/gtest.h>

#include "refinement_case.h"

namespace colloid {
namespace {

TEST(TransientRefinement, NearAColloidGivesTheDragOfRefinementEverywhere) {
  EXPECT_LT(refinement_error(14), refinement_bound(14));
}

}  // namespace
}  // namespace colloid
