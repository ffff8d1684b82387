// The bounds on which the certificate rests, one by one.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "gtest/gtest.h"
#include "observe/clearance.h"
#include "observe/max_min.h"
#include "packings.h"

namespace colloid {
namespace {

struct Scene {
  std::vector<Surface> surfaces;
  std::vector<int> every;
};

Scene random_scene(std::mt19937_64& random) {
  Scene scene;
  scene.surfaces = surfaces_of(flow_box({1, 1, 1}, FaceCondition::wall),
                               random_cluster({1, 1, 1}, 12, random()), {});
  scene.every.resize(scene.surfaces.size());
  std::iota(scene.every.begin(), scene.every.end(), 0);
  return scene;
}

double clearance_in(const Scene& scene, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Surface& surface : scene.surfaces) {
    least = std::min(least, distance(surface, point));
  }
  return least;
}

// No sample of a cell exceeds its upper bound; no sample falls below what `climb` attains
// by more than sampling explains (it is a local maximum: only the point itself is
// checked).
TEST(Bounds, HoldAtRandomPointsOfRandomCells) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const Scene scene = random_scene(random);
    Extent cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell.lo[axis] = uniform(random);
      cell.hi[axis] = cell.lo[axis] + std::pow(10.0, -4.0 * uniform(random)) * 0.5;
    }
    const auto count = static_cast<int>(scene.every.size());
    const double bound = upper_clearance(scene.surfaces, scene.every.data(), count, cell);
    const Summit summit = climb(scene.surfaces, scene.every.data(), count, cell);
    EXPECT_EQ(summit.clearance, clearance_in(scene, summit.point));
    EXPECT_LE(summit.clearance, bound + 1e-15);
    EXPECT_GE(summit.clearance, clearance_in(scene, cell.center()));
    for (int sample = 0; sample < 100; ++sample) {
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = cell.lo[axis] + (cell.hi[axis] - cell.lo[axis]) * uniform(random);
      }
      EXPECT_LE(clearance_in(scene, point), bound + 1e-15);
    }
  }
}

// At a bottleneck of three spheres the bound closes with the square of the cell: a tenth
// of the size, a hundredth of the excess.  With one surface alone it would be a tenth.
TEST(Bounds, CloseAtSecondOrder) {
  const std::vector<Sphere> spheres = {
      {{0, 0, 0}, 0.5}, {{1.1, 0, 0}, 0.55}, {{0.4, 0.9, 0}, 0.4}};
  const std::vector<Surface> surfaces =
      surfaces_of(flow_box({9, 9, 9}, FaceCondition::symmetry), spheres, {});
  const std::vector<int> every = {0, 1, 2};
  const Summit top = climb(surfaces, every.data(), 3, {{0.2, 0.1, 0}, {0.8, 0.6, 0}});
  double excess = 0.0;
  for (const double half : {1e-2, 1e-3, 1e-4}) {
    const Vec3 h{half, 0.7 * half, 0.9 * half};
    const double now =
        upper_clearance(surfaces, every.data(), 3, {top.point - h, top.point + h}) -
        top.clearance;
    EXPECT_GT(now, 0.0);
    if (excess > 0.0) {
      EXPECT_NEAR(now / excess, 0.01, 0.001);
    }
    excess = now;
  }
}

TEST(Clearance, KnowsWallsAndPeriodicImages) {
  Box box = periodic_box({1, 1, 1});
  box.faces[z_minus] = box.faces[z_plus] = FaceCondition::wall;
  const std::vector<Sphere> spheres = {{{0.05, 0.5, 0.5}, 0.1}};
  const Clearance over_the_edge = clearance(box, spheres, {0.9, 0.5, 0.5});
  EXPECT_NEAR(over_the_edge.distance, 0.05, 1e-15);
  EXPECT_EQ(over_the_edge.nearest, (SurfaceName{SurfaceName::Kind::sphere, 0}));
  const Clearance near_wall = clearance(box, spheres, {0.5, 0.5, 0.98});
  EXPECT_NEAR(near_wall.distance, 0.02, 1e-15);
  EXPECT_EQ(near_wall.nearest, (SurfaceName{SurfaceName::Kind::wall, z_plus}));
  EXPECT_NEAR(clearance(box, spheres, {5.05, -2.5, 0.5}).distance, -0.1, 1e-14);
  EXPECT_TRUE(std::isinf(clearance(periodic_box({1, 1, 1}), {}, {0, 0, 0}).distance));
}

}  // namespace
}  // namespace colloid
