#include "flow/grid.h"

#include <gtest/gtest.h>

#include "flow/axis_stencil.h"
#include "flow/halo.h"

namespace colloid {
namespace {

TEST(Grid, IndicesOfOneLevelAreDistinctAndInside) {
  const Grid grid = make_grid({3.0, 2.0, 4.0}, {3, 2, 4}, {true, false, false});
  std::vector<int> seen(grid.size, 0);
  for (int k = -1; k <= 4; ++k) {
    for (int j = -1; j <= 2; ++j) {
      for (int i = -1; i <= 3; ++i) {
        ASSERT_LT(grid.index(i, j, k), grid.size);
        EXPECT_EQ(seen[grid.index(i, j, k)]++, 0);
      }
    }
  }
}

TEST(Grid, CoarseningKeepsTheExtentAndMakesEvenNumbers) {
  const Grid fine = make_grid({7.0, 4.0, 5.0}, {7, 4, 5}, {true, true, false});
  const Grid coarse = coarsen(fine, {true, true, true});
  EXPECT_EQ(coarse.cells, (std::array<int, 3>{4, 2, 2}));
  EXPECT_DOUBLE_EQ(coarse.position[0].back(), 7.0);
  EXPECT_DOUBLE_EQ(coarse.width[0].back(), 1.0);  // left alone
  EXPECT_DOUBLE_EQ(coarse.position[2].back(), 5.0);
  EXPECT_DOUBLE_EQ(coarse.width[2].back(), 3.0);  // joined to the pair before
  EXPECT_DOUBLE_EQ(coarse.width[0].front(), 2.0);
}

TEST(Halo, WrapsPeriodicAxesAndLeavesTheOthers) {
  const Grid grid = make_grid({3.0, 2.0, 2.0}, {3, 2, 2}, {true, false, true});
  std::vector<double> x(grid.size, 0.0);
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 3; ++i) {
        x[grid.index(i, j, k)] = 100 * k + 10 * j + i + 1;
      }
    }
  }
  std::vector<double> by_plane = x;
  fill_halo(grid, x.data());
  EXPECT_EQ(x[grid.index(-1, 1, 0)], 13.0);
  EXPECT_EQ(x[grid.index(3, 0, 1)], 101.0);
  EXPECT_EQ(x[grid.index(1, 1, -1)], 112.0);
  EXPECT_EQ(x[grid.index(-1, 0, 2)], 3.0);
  EXPECT_EQ(x[grid.index(1, -1, 0)], 0.0);
  for (int k = 0; k < 2; ++k) {
    fill_halo_of_plane(grid, by_plane.data(), k);
  }
  for (int k = -1; k <= 2; ++k) {
    for (int j = 0; j < 2; ++j) {
      for (int i = -1; i <= 3; ++i) {
        EXPECT_EQ(by_plane[grid.index(i, j, k)], x[grid.index(i, j, k)]);
      }
    }
  }
}

// Differences of 1, x and x^2 are exact wherever both neighbours exist, narrow cells too.
TEST(AxisStencil, SecondDifferencesOfAParabolaAreExact) {
  const Grid fine = make_grid({7.0, 4.0, 4.0}, {7, 4, 4}, {false, false, false});
  const Grid grid = coarsen(fine, {true, true, true});
  const AxisStencil s =
      make_axis_stencil(grid, 0, FlowFace::Kind::velocity, FlowFace::Kind::pressure);
  for (std::size_t i = 1; i < 4; ++i) {
    const SecondDifference& d = s.at_face[i];
    const double x = grid.position[0][i];
    const auto u = [](double y) { return 3.0 + 2.0 * y + 0.5 * y * y; };
    const double value = d.prefactor * ((u(x + d.above) - u(x)) / d.above -
                                        (u(x) - u(x - d.below)) / d.below);
    EXPECT_NEAR(value, 1.0, 1e-12);
  }
  // A wall with a given velocity is half a cell from the first centre.
  EXPECT_EQ(s.at_centre[0].side_below, Side::given_velocity);
  EXPECT_DOUBLE_EQ(s.at_centre[0].below, 1.0);
  EXPECT_EQ(s.at_centre[3].side_above, Side::no_shear);
  EXPECT_EQ(s.centre_above[4], 0.0F);
}

}  // namespace
}  // namespace colloid
