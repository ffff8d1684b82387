// The same on a finer grid, and at other gaps and places: see README.md beside this file.
#include <gtest/gtest.h>

#include "approach_expectations.h"
#include "sliding_expectations.h"

namespace colloid {
namespace {

TEST(TransientLubricationFine, AddsWhatAFlowOfSixteenCellsMisses) {
  expect_exact(16);
}

TEST(TransientLubricationFine, IsThatOfTwoColloidsAndOfAGrainToo) {
  for (const Vec3& along : {Vec3{0.0, 0.0, 1.0}, Vec3{1.0, 2.0, 3.0}}) {
    for (const Other other : {Other::colloid, Other::grain}) {
      expect_exact_at(other, 10, along, {0.02, 0.2, 0.4, 1.0, 2.5});
      expect_exact_at(other, 16, along, {0.1, 0.7});
    }
  }
}

TEST(TransientLubricationFine, AddsWhatAFlowOfSixteenCellsMissesOfSlidingAndTurning) {
  expect_sliding(Beside::wall, 16, {0.0, 0.0, 1.0},
                 {0.02, 0.07, 0.25, 0.45, 0.7, 1.1, 2.0});
  for (const Beside other : {Beside::grain, Beside::colloid}) {
    expect_sliding(other, 10, {0.0, 0.0, 1.0}, {0.02, 0.25, 0.7, 1.1});
    expect_sliding(other, 16, {1.0, 2.0, 3.0}, {0.02, 0.25, 0.7});
  }
}

}  // namespace
}  // namespace colloid
