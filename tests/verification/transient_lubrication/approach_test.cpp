// The flow's own resistance to approach and sub-grid lubrication together are the exact
// one: see README.md beside this file.
#include <gtest/gtest.h>

#include "approach_expectations.h"

namespace colloid {
namespace {

TEST(TransientLubrication, AddsWhatAFlowOfTenCellsMisses) {
  expect_exact(10);
}

TEST(TransientLubrication, IsThatOfTwoColloidsAndOfAGrainToo) {
  expect_exact_at(Other::colloid, 10, {1.0, 2.0, 3.0}, {0.1, 0.7});
  expect_exact_at(Other::grain, 10, {0.0, 0.0, 1.0}, {0.1, 0.7});
}

}  // namespace
}  // namespace colloid
