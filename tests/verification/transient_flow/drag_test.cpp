// Drag on a periodic array of fixed spheres: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "array_case.h"

namespace colloid {
namespace {

TEST(TransientDrag, OfASimpleCubicArrayConvergesAtSecondOrder) {
  expect_array(16);  // 9.9 cells per diameter
  const double coarse = expect_array(13);
  const double fine = expect_array(26);
  // A quarter each: at the finer grid a quarter of the coarser one's error is left.
  EXPECT_GT(std::abs(coarse), 2.8 * std::abs(fine));
}

TEST(TransientDrag, HardlyDependsOnThePlaceInTheGrid) {
  const double centred = array_drag(16, 0.0, 1e-3).coefficient;
  for (const double shift : {0.25, 0.5}) {
    EXPECT_NEAR(array_drag(16, shift, 1e-3).coefficient / centred, 1.0, 0.01) << shift;
  }
}

// A steady flow does not know the step by which it came to rest.
TEST(TransientDrag, DoesNotDependOnTheStep) {
  EXPECT_NEAR(
      array_drag(16, 0.0, 1e-4).coefficient / array_drag(16, 0.0, 1e-2).coefficient, 1.0,
      2e-3);
}

TEST(TransientDrag, BalancesTheForceOnTheLiquid) {
  EXPECT_NEAR(array_drag(16, 0.3, 1e-3).balance, 1.0, 2e-3);
}

}  // namespace
}  // namespace colloid
