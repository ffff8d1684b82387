#include "flow/connectivity.h"

#include <cmath>

#include <gtest/gtest.h>

#include "flow_cases.h"

namespace colloid {
namespace {

// A plate of spheres across the middle of a box of walls, 3 x 3 on a lattice of 4 cells.
std::vector<Sphere> plate(double radius) {
  std::vector<Sphere> spheres;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      spheres.push_back({{4.0 * i, 4.0 * j, 6.0}, radius});
    }
  }
  return spheres;
}

struct Pore {
  explicit Pore(double radius)
      : spheres(plate(radius)),
        rows(make_grid({8.0, 8.0, 12.0}, {8, 8, 12}, {false, false, false}),
             FlowFaces{}) {
    rows.add(spheres);
  }
  std::size_t top() const { return rows.grid().index(3, 3, 11); }
  std::size_t bottom() const { return rows.grid().index(3, 3, 0); }
  std::vector<Sphere> spheres;
  WallRows rows;
};

TEST(Connectivity, CellsJoinedByOpenFacesShareALabel) {
  Pore open(2.0);
  Connectivity regions(open.rows);
  EXPECT_EQ(regions.label(open.top()), regions.label(open.bottom()));
  EXPECT_EQ(open_subgrid_throats(open.rows, open.spheres, {open.top()}, {open.bottom()}),
            0);
}

// The holes of the plate lie on grid lines, at the corners of faces: closed on the grid
// when they are small, open in truth while the radius is below 2 sqrt 2.
TEST(Connectivity, OpensTheWidestSubGridThroatOnly) {
  Pore narrow(2.0 * std::sqrt(2.0) - 0.02);
  Connectivity before(narrow.rows);
  ASSERT_NE(before.label(narrow.top()), before.label(narrow.bottom()));
  const int opened = open_subgrid_throats(narrow.rows, narrow.spheres, {narrow.top()},
                                          {narrow.bottom()});
  EXPECT_GE(opened, 1);
  EXPECT_LE(opened, 8);
  Connectivity after(narrow.rows);
  EXPECT_EQ(after.label(narrow.top()), after.label(narrow.bottom()));
}

TEST(Connectivity, FindsNoWayThroughAClosedPlate) {
  Pore closed(2.0 * std::sqrt(2.0) + 0.02);
  EXPECT_EQ(open_subgrid_throats(closed.rows, closed.spheres, {closed.top()},
                                 {closed.bottom()}),
            -1);
}

}  // namespace
}  // namespace colloid
