// The flow's own resistance and sub-grid lubrication together are the exact one: see
// README.md beside this file.
#include <gtest/gtest.h>

#include "approach_expectations.h"
#include "sliding_expectations.h"

namespace colloid {
namespace {

TEST(TransientLubrication, AddsWhatAFlowOfTenCellsMisses) {
  expect_exact(10);
}

TEST(TransientLubrication, IsThatOfTwoColloidsAndOfAGrainToo) {
  expect_exact_at(Other::colloid, 10, {1.0, 2.0, 3.0}, {0.1, 0.7});
  expect_exact_at(Other::grain, 10, {0.0, 0.0, 1.0}, {0.1, 0.7});
}

// At the first place no cell's centre lies between the surfaces: the liquid would be shut
// in if the cells nearest to the grain were rigid, and the resistance 8.1.
TEST(TransientLubrication, LeavesAGapOpenWhereverItLiesInTheGrid) {
  const auto at = [](double height) {
    return resolved_meeting(Other::grain, 10, 0.55, {0.18, 0.37}, {0.0, 0.0, 1.0},
                            height);
  };
  const double without = at(0.05);
  const double with = at(0.3);
  std::printf("%.3f and %.3f\n", without, with);
  EXPECT_NEAR(without / with, 1.0, 2.0 * (kTolerance + 0.02));  // each is within that
}

TEST(TransientLubrication, AddsWhatTheFlowMissesOfSlidingAndTurning) {
  expect_sliding(Beside::wall, 10, {0.0, 0.0, 1.0}, {0.02, 0.25, 0.7});
  expect_sliding(Beside::colloid, 10, {1.0, 2.0, 3.0}, {0.07});
}

}  // namespace
}  // namespace colloid
