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

TEST(TransientLubricationFine, AddsWhatTheFlowMissesOfSlidingAndTurning) {
  for (const int cells : {10, 16}) {
    expect_sliding(Beside::wall, cells, {0.0, 0.0, 1.0},
                   {0.02, 0.07, 0.25, 0.45, 1.1, 2.0});
    for (const Beside other : {Beside::grain, Beside::colloid}) {
      expect_sliding(other, cells, {1.0, 2.0, 3.0}, {0.02, 0.25, 0.7});
    }
  }
  for (const Beside other : {Beside::grain, Beside::colloid}) {
    expect_sliding(other, 10, {0.0, 0.0, 1.0}, {0.07, 0.45, 1.1});
  }
}

}  // namespace
}  // namespace colloid
