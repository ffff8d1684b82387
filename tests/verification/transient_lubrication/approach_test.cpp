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

TEST(TransientLubrication, AddsWhatTheFlowMissesOfSlidingAndTurning) {
  expect_sliding(Beside::wall, 10, {0.0, 0.0, 1.0}, {0.02, 0.25, 0.7});
  expect_sliding(Beside::colloid, 10, {1.0, 2.0, 3.0}, {0.07});
}

}  // namespace
}  // namespace colloid
