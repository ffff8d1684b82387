// Flow and sub-grid lubrication together against the exact resistance to approach: see
// README.md beside this file.
#pragma once

#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "approach_case.h"

namespace colloid {

constexpr double kTolerance = 0.05;

// Error of both together over Brenner's resistance.
inline double error(int cells, double gap, const Place& place, double far) {
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
inline void expect_exact(int cells) {
  const Place place{0.18, 0.37};
  const double far = far_walls(cells, place);
  for (const double gap : {0.02, 0.07, 0.2, 0.4, 0.7, 1.1, 2.0}) {
    EXPECT_NEAR(error(cells, gap, place, far), 0.0, kTolerance) << gap;
  }
}

// (T9) was made at a wall on the grid.  Another sphere is cut by it and has an error of
// its own in the flow: 2 %, as the drag of one that is held (../transient_flow).
inline void expect_exact_at(Other other, int cells, const Vec3& along,
                            const std::vector<double>& gaps) {
  const Place place{0.18, 0.37};
  const double far = far_walls(other, cells, place, along);
  for (const double gap : gaps) {
    const double flow = resolved_meeting(other, cells, gap, place, along) - far;
    const double sub_grid = sub_grid_meeting(other, cells, gap);
    const double exact = exact_meeting(other, gap * 2.0 / cells);
    std::printf("gap %.2f: flow %.3f + sub-grid %.3f, exact %.3f: %+.1f %%\n", gap, flow,
                sub_grid, exact, 100.0 * ((flow + sub_grid) / exact - 1.0));
    EXPECT_NEAR((flow + sub_grid) / exact, 1.0, kTolerance + 0.02) << gap;
  }
}

}  // namespace colloid
