// Flow and sub-grid lubrication together against the exact resistance to sliding and
// turning: see README.md beside this file.
#pragma once

#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "sliding_case.h"

namespace colloid {

/// What the walls of the box add to the force of sliding, measured where the grid sees
/// all of the gap: nothing beside a wall or between colloids that slide against each
/// other, whose forces end there.
inline double far_walls_of_sliding(Beside beside, int cells, const Place& place,
                                   const Vec3& from_other) {
  constexpr double kWide = 5.0;  // cells
  return beside == Beside::grain
             ? resolved_sliding(beside, cells, kWide, place, from_other).f_t -
                   exact_sliding(beside, kWide * 2.0 / cells).f_t
             : 0.0;
}

// At a place in the grid, and gaps, that (T10) was not made from.
inline void expect_sliding(Beside beside, int cells, const Vec3& from_other,
                           const std::vector<double>& gaps) {
  const Place place{0.18, 0.37};
  const double tolerance = beside == Beside::wall ? 0.05 : 0.07;
  const double far = far_walls_of_sliding(beside, cells, place, from_other);
  for (const double gap : gaps) {
    Sliding flow = resolved_sliding(beside, cells, gap, place, from_other);
    flow.f_t -= far;
    const Sliding all = flow + sub_grid_sliding(beside, cells, gap, from_other);
    const Sliding exact = exact_sliding(beside, gap * 2.0 / cells);
    std::printf(
        "%d cells, gap %.2f: f_t %.3f of %.3f, t_t %.3f and %.3f of %.3f, t_r %.3f "
        "of %.3f (flow alone %.3f, %.3f, %.3f, %.3f)\n",
        cells, gap, all.f_t, exact.f_t, all.t_t, all.f_r, exact.t_t, all.t_r, exact.t_r,
        flow.f_t, flow.t_t, flow.f_r, flow.t_r);
    EXPECT_NEAR(all.f_t / exact.f_t, 1.0, tolerance) << gap;
    EXPECT_NEAR(all.t_r / exact.t_r, 1.0, tolerance) << gap;
    // The coupling is less than either: what counts is its part of the force.
    EXPECT_NEAR(all.t_t, exact.t_t, tolerance * exact.f_t) << gap;
    EXPECT_NEAR(all.f_r, exact.f_r, tolerance * exact.f_t) << gap;
  }
}

}  // namespace colloid
