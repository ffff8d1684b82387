// The flow's own resistance to approach and sub-grid lubrication together are Brenner's:
// see README.md beside this file.
#include <cstdio>

#include <gtest/gtest.h>

#include "approach_case.h"
#include "tiers/transient/dem_lubrication.h"

namespace colloid {
namespace {

constexpr double kTolerance = 0.05;

// Error of both together over Brenner's resistance.
double error(int cells, double gap, const Place& place, double far) {
  const double a = kApproachRadius;
  const double cell = 2.0 * a / cells;
  const double mu = 1e-3;
  const double sub_grid =
      lubrication_resistance(mu, a, gap * cell, cell, 1e-12) / (6.0 * kPi * mu * a);
  const double exact = wall_resistance(gap * 2.0 / cells).f_n;
  const double found = resolved_approach(cells, gap, place) - far;
  std::printf("%d cells, gap %.2f: flow %.3f + sub-grid %.3f, exact %.3f: %+.1f %%\n",
              cells, gap, found, sub_grid, exact,
              100.0 * ((found + sub_grid) / exact - 1.0));
  return (found + sub_grid) / exact - 1.0;
}

// At a place in the grid, and gaps, that the table was not made from.
void expect_exact(int cells) {
  const Place place{0.18, 0.37};
  const double far = far_walls(cells, place);
  for (const double gap : {0.02, 0.07, 0.2, 0.4, 0.7, 1.1, 2.0}) {
    EXPECT_NEAR(error(cells, gap, place, far), 0.0, kTolerance) << gap;
  }
}

TEST(TransientLubrication, AddsWhatAFlowOfTenCellsMisses) {
  expect_exact(10);
}

TEST(TransientLubrication, AddsWhatAFlowOfSixteenCellsMisses) {
  expect_exact(16);
}

}  // namespace
}  // namespace colloid
