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

bool joined(Pore& pore) {
  return Connectivity(pore.rows, true).joined({pore.top()}, {pore.bottom()});
}

TEST(Connectivity, CellsJoinedByOpenFacesShareALabel) {
  Pore open(2.0);
  EXPECT_TRUE(joined(open));
}

// The holes of the plate lie on grid lines, at the corners of faces: closed on the grid
// when they are small, open in truth while the radius is below 2 sqrt 2.
TEST(Connectivity, OpensEverySubGridThroat) {
  Pore narrow(2.0 * std::sqrt(2.0) - 0.02);
  ASSERT_FALSE(joined(narrow));
  const int opened = open_subgrid_throats(narrow.rows, narrow.spheres);
  EXPECT_TRUE(joined(narrow));
  // Four whole holes, each touching the four faces around its grid line on every level of
  // cells that the spheres close.
  EXPECT_GE(opened, 16);
  EXPECT_EQ(opened % 4, 0);
}

TEST(Connectivity, FindsNoWayThroughAClosedPlate) {
  Pore closed(2.0 * std::sqrt(2.0) + 0.02);
  open_subgrid_throats(closed.rows, closed.spheres);
  EXPECT_FALSE(joined(closed));
}

TEST(Connectivity, WindsAroundAPeriodThatIsOpen) {
  FlowFaces faces;
  for (FlowFace& f : faces) {
    f.kind = FlowFace::Kind::periodic;
  }
  const Grid grid = make_grid({8.0, 8.0, 8.0}, {8, 8, 8}, {true, true, true});
  // One sphere leaves every direction open; one that fills the box's cross-section but
  // for its edges in y and z closes none of x, y, z beside it; a plate of four closes z
  // alone.
  WallRows single(grid, faces);
  single.add(Sphere{{4.0, 4.0, 4.0}, 2.5});
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(winds_around(single, axis));
  }
  WallRows plate_across(grid, faces);
  for (double x : {0.0, 4.0}) {
    for (double y : {0.0, 4.0}) {
      plate_across.add(Sphere{{x, y, 4.0}, 2.95});
    }
  }
  EXPECT_TRUE(winds_around(plate_across, 0));
  EXPECT_TRUE(winds_around(plate_across, 1));
  EXPECT_FALSE(winds_around(plate_across, 2));
}

}  // namespace
}  // namespace colloid
