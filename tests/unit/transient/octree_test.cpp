// The octree grid: cells are found by place, and every cell is closed.
#include "tiers/transient/octree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "particles/surfaces.h"

namespace colloid {
namespace {

constexpr double kSpacing = 2.0e-6;
constexpr Index3 kCells{7, 5, 6};

// Levels 0 to 2 and cells left out, at random; periodic along x.
OctreeLevels random_levels(unsigned seed) {
  std::mt19937 random(seed);
  OctreeLevels levels;
  levels.box.size = {kCells[0] * kSpacing, kCells[1] * kSpacing, kCells[2] * kSpacing};
  levels.box.faces = {FaceCondition::periodic, FaceCondition::periodic,
                      FaceCondition::wall,     FaceCondition::wall,
                      FaceCondition::outlet,   FaceCondition::inlet};
  levels.cells = kCells;
  std::discrete_distribution<int> choice({0.1, 0.6, 0.2, 0.1});
  for (int n = 0; n < kCells[0] * kCells[1] * kCells[2]; ++n) {
    levels.level.push_back(choice(random) - 1);
  }
  balance(levels);
  return levels;
}

OctreeMesh whole(const OctreeLevels& levels) {
  return build_mesh(levels, partition(levels, 1), 0);
}

TEST(Octree, FindsAllCellsAroundAPlaceAndFewOthers) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  for (unsigned seed = 0; seed < 4; ++seed) {
    const OctreeLevels levels = random_levels(seed);
    const OctreeMesh mesh = whole(levels);
    for (int trial = 0; trial < 50; ++trial) {
      const Vec3& size = levels.box.size;
      const Vec3 x{anywhere(random) * size.x, anywhere(random) * size.y,
                   anywhere(random) * size.z};
      const double reach = anywhere(random) * 5.0 * kSpacing;
      const std::vector<int> found = cells_around(levels, mesh, x, reach);
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      for (int cell = 0; cell < static_cast<int>(mesh.centres.size()); ++cell) {
        const Vec3 e =
            shortest(levels.box, mesh.centres[static_cast<std::size_t>(cell)], x);
        const double farthest = std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)});
        const bool is_found = std::binary_search(found.begin(), found.end(), cell);
        if (farthest <= reach) {
          EXPECT_TRUE(is_found) << "cell " << cell << " of " << seed << ", " << trial;
        }
        // A base cell that is touched counts as a whole.
        if (farthest > reach + kSpacing) {
          EXPECT_FALSE(is_found) << "cell " << cell << " of " << seed << ", " << trial;
        }
      }
    }
  }
}

TEST(Octree, CountsNoCellTwiceWhereAPeriodicBoxIsShorterThanTheReach) {
  const OctreeLevels levels = random_levels(1);
  const OctreeMesh mesh = whole(levels);
  const std::vector<int> found =
      cells_around(levels, mesh, levels.box.size * 0.5, 10.0 * levels.box.size.x);
  std::vector<int> all(mesh.centres.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(found, all);
}

TEST(Octree, DividesBaseCellsAmongRanks) {
  const OctreeLevels levels = random_levels(2);
  const std::vector<int> rank_of = partition(levels, 2);
  std::size_t found = 0;
  for (int rank = 0; rank < 2; ++rank) {
    const OctreeMesh mesh = build_mesh(levels, rank_of, rank);
    const std::vector<int> cells =
        cells_around(levels, mesh, levels.box.size * 0.5, levels.box.size.z * 10.0);
    EXPECT_EQ(cells.size(), mesh.centres.size());
    found += cells.size();
  }
  EXPECT_EQ(found, whole(levels).centres.size());
}

TEST(Octree, HasClosedCellsThatFillWhatIsNotLeftOut) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const OctreeLevels levels = random_levels(seed);
    const OctreeMesh mesh = whole(levels);
    // Of each cell: the sum of its faces' areas, outward, and by Gauss' theorem its
    // volume.
    std::vector<Vec3> areas(mesh.centres.size());
    std::vector<double> volumes(mesh.centres.size(), 0.0);
    const auto add = [&](int cell, const Vec3& area, const Vec3& middle) {
      const auto c = static_cast<std::size_t>(cell);
      areas[c] += area;
      volumes[c] += dot(middle - mesh.centres[c], area) / 3.0;
    };
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      std::array<Vec3, 4> corner;
      Vec3 middle;
      for (std::size_t c = 0; c < 4; ++c) {
        corner[c] = mesh.points[static_cast<std::size_t>(mesh.faces[f][c])];
        middle += corner[c] * 0.25;
      }
      const Vec3 area = cross(corner[2] - corner[0], corner[3] - corner[1]) * 0.5;
      add(mesh.owner[f], area, middle);
      if (f < mesh.neighbour.size()) {
        add(mesh.neighbour[f], -area, middle);
      }
    }
    double sum = 0.0;
    for (std::size_t cell = 0; cell < volumes.size(); ++cell) {
      const double size = mesh.size[cell];
      EXPECT_NEAR(norm(areas[cell]), 0.0, 1e-9 * size * size);
      EXPECT_NEAR(volumes[cell], size * size * size, 1e-9 * size * size * size);
      sum += volumes[cell];
    }
    const auto there = std::count_if(levels.level.begin(), levels.level.end(),
                                     [](int level) { return level >= 0; });
    const double expected = static_cast<double>(there) * kSpacing * kSpacing * kSpacing;
    EXPECT_NEAR(sum, expected, 1e-9 * expected);
  }
}

}  // namespace
}  // namespace colloid
