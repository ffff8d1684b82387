// Random clusters against a dense grid, and what must not change l_c.
//
// Reference  grid_search.h: clearances at grid points, breadth-first search, its own
// bounds. Tolerance  none: the solver's interval must meet the grid's, at two
// resolutions.  The
//            grid's is some per cent wide; an error of 1e-9 in the solver's upper bounds
//            shows where the box is cut differently through the same packing, below.
#include <algorithm>
#include <cmath>

#include "grid_search.h"
#include "gtest/gtest.h"
#include "observe/critical_diameter.h"
#include "packings.h"

namespace colloid {
namespace {

Box box_of(int kind, const Vec3& size) {
  switch (kind) {
    case 0:
      return flow_box(size, FaceCondition::wall);
    case 1:
      return flow_box(size, FaceCondition::symmetry);
    case 2:
      return periodic_box(size);
    case 3: {  // periodic across, inlet and outlet
      return flow_box(size, FaceCondition::periodic);
    }
    default: {  // a wall, a symmetry face, a period; around z
      Box box = periodic_box(size);
      box.faces[x_minus] = FaceCondition::wall;
      box.faces[x_plus] = FaceCondition::symmetry;
      return box;
    }
  }
}

Packing random_packing(int kind, std::uint64_t seed) {
  std::mt19937_64 random(1000 * seed + static_cast<std::uint64_t>(kind));
  const int count = 10 + static_cast<int>(140.0 * uniform(random) * uniform(random));
  const Vec3 size{1.0, 0.8 + 0.5 * uniform(random), 0.8 + 1.2 * uniform(random)};
  return {box_of(kind, size), random_cluster(size, count, random())};
}

class RandomClusters : public testing::TestWithParam<int> {};

TEST_P(RandomClusters, AgreeWithADenseGridAtTwoResolutions) {
  int open = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Packing packing = random_packing(GetParam(), seed);
    const CriticalDiameter found = critical_diameter(packing.box, packing.spheres);
    for (const int per_edge : {20, 40}) {
      const Bracket grid = grid_critical_diameter(packing, per_edge);
      EXPECT_LE(found.value, std::max(0.0, grid.high)) << "seed " << seed;
      EXPECT_GE(found.value + found.error, grid.low) << "seed " << seed;
    }
    const double smallest =
        std::min_element(
            packing.spheres.begin(), packing.spheres.end(),
            [](const Sphere& a, const Sphere& b) { return a.radius < b.radius; })
            ->radius;
    EXPECT_LE(found.error, 2e-9 * smallest * (1.0 + 1e-6)) << "seed " << seed;
    open += found.blocked ? 0 : 1;
  }
  EXPECT_GE(open, 3);  // the sample is not all blocked
}

TEST_P(RandomClusters, PermutedAxesAndOtherUnitsChangeNothing) {
  for (std::uint64_t seed = 11; seed <= 16; ++seed) {
    const Packing packing = random_packing(GetParam(), seed);
    const CriticalDiameter found = critical_diameter(packing.box, packing.spheres);
    CriticalDiameterOptions options;
    options.flow_axis = 0;
    const Packing turned = permuted(packing);
    const CriticalDiameter other = critical_diameter(turned.box, turned.spheres, options);
    EXPECT_NEAR(found.value, other.value, found.error + other.error + 1e-13);
    Packing small = packing;
    small.box.size *= 1e-7;
    for (Sphere& sphere : small.spheres) {
      sphere.center *= 1e-7;
      sphere.radius *= 1e-7;
    }
    const CriticalDiameter scaled = critical_diameter(small.box, small.spheres);
    EXPECT_NEAR(found.value, 1e7 * scaled.value,
                found.error + 1e7 * scaled.error + 1e-13);
  }
}

TEST_P(RandomClusters, AnotherSphereNeverWidensThem) {
  for (std::uint64_t seed = 21; seed <= 24; ++seed) {
    const Packing packing = random_packing(GetParam(), seed);
    std::vector<Sphere> spheres;
    double last = std::numeric_limits<double>::infinity();
    for (const Sphere& sphere : packing.spheres) {
      spheres.push_back(sphere);
      if (spheres.size() % 8 == 0) {
        const CriticalDiameter found = critical_diameter(packing.box, spheres);
        EXPECT_LE(found.value, last + 1e-13);
        last = found.value + found.error;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, RandomClusters, testing::Values(0, 1, 2, 3, 4));

// Shifted along its periods the packing is cut by other cells: both bounds are put to
// test.
TEST(PeriodicClusters, AnyShiftChangesNothing) {
  for (std::uint64_t seed = 31; seed <= 38; ++seed) {
    const Packing packing = random_packing(2, seed);
    const CriticalDiameter found = critical_diameter(packing.box, packing.spheres);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 3; ++trial) {
      const Vec3 shift{3.0 * uniform(random), -uniform(random), uniform(random)};
      std::vector<Sphere> moved = packing.spheres;
      for (Sphere& sphere : moved) {
        sphere.center += shift;
      }
      const CriticalDiameter other = critical_diameter(packing.box, moved);
      EXPECT_NEAR(found.value, other.value, found.error + other.error + 1e-13);
    }
  }
}

// Two periods as one: a way that closes after two turns closes after one.
TEST(PeriodicClusters, DoubledPeriodChangesNothing) {
  const Packing packing = random_packing(2, 41);
  Packing doubled = packing;
  doubled.box.size.z *= 2.0;
  for (const Sphere& sphere : packing.spheres) {
    doubled.spheres.push_back(
        {sphere.center + Vec3{0, 0, packing.box.size.z}, sphere.radius});
  }
  const CriticalDiameter one = critical_diameter(packing.box, packing.spheres);
  const CriticalDiameter two = critical_diameter(doubled.box, doubled.spheres);
  EXPECT_NEAR(one.value, two.value, one.error + two.error + 1e-13);
}

}  // namespace
}  // namespace colloid
