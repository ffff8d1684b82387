#include "scene/solid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/scene.h"
#include "scene/throat.h"

namespace colloid {
namespace {

Box cube(FaceCondition all) {
  return {{1.0, 1.0, 1.0}, {all, all, all, all, all, all}};
}

TEST(Solid, GapsAreThoseOfTheNearestPeriodicImages) {
  const Sphere a{{0.1, 0.5, 0.5}, 0.05};
  const Sphere b{{0.9, 0.5, 0.5}, 0.05};
  EXPECT_NEAR(surface_gap(cube(FaceCondition::wall), a, b), 0.7, 1e-15);
  EXPECT_NEAR(surface_gap(cube(FaceCondition::periodic), a, b), 0.1, 1e-15);
}

// A ball in the middle holds pi/6; one on a corner of a periodic cube does too, and an
// eighth of it between walls.  Tolerance: 1 % of the box, as the header says.
TEST(Solid, VoidFractionIsWhatTheBallsLeave) {
  const double ball = 3.14159265358979 / 6.0;
  const Box walls = cube(FaceCondition::wall);
  EXPECT_EQ(void_fraction(walls, {}), 1.0);
  EXPECT_NEAR(void_fraction(walls, {{{0.5, 0.5, 0.5}, 0.5}}), 1.0 - ball, 0.01);
  EXPECT_NEAR(void_fraction(walls, {{{0.0, 1.0, 0.0}, 0.5}}), 1.0 - ball / 8.0, 0.01);
  EXPECT_NEAR(void_fraction(cube(FaceCondition::periodic), {{{0.0, 1.0, 0.0}, 0.5}}),
              1.0 - ball, 0.01);
  EXPECT_EQ(void_fraction(walls, {{{0.5, 0.5, 0.5}, 1.0}}), 0.0);
}

TEST(Solid, ABallReachesIntoTheBoxIfItsSurfacePassesTheNearestCorner) {
  const Box box = cube(FaceCondition::wall);
  EXPECT_TRUE(reaches_into(box, {{-0.1, 0.5, 0.5}, 0.2}));
  EXPECT_FALSE(reaches_into(box, {{-0.1, 0.5, 0.5}, 0.1}));
  EXPECT_TRUE(reaches_into(box, {{1.1, 1.1, 1.1}, 0.1 * std::sqrt(3.0) + 1e-9}));
  EXPECT_FALSE(reaches_into(box, {{1.1, 1.1, 1.1}, 0.1 * std::sqrt(3.0) - 1e-9}));
}

// Balls of a simple-cubic array fill space when they reach the corners of the cell, at
// d = sqrt(3) L, and close the faces at d = sqrt(2) L.
TEST(Solid, FindsTheVoidOfASimpleCubicArrayUntilItIsGone) {
  const Box box = cube(FaceCondition::periodic);
  const auto array = [](double d) {
    return std::vector<Sphere>{{{0.5, 0.5, 0.5}, 0.5 * d}};
  };
  EXPECT_TRUE(has_void(box, {}));
  EXPECT_TRUE(has_void(box, array(0.95 * std::sqrt(3.0))));
  EXPECT_FALSE(has_void(box, array(1.001 * std::sqrt(3.0))));
  EXPECT_TRUE(has_void_on_face(box, array(0.99), z_minus));
  const std::vector<Sphere> at_corner{{{0.0, 0.0, 0.0}, 0.5 * std::sqrt(2.0) * 1.001}};
  EXPECT_FALSE(has_void_on_face(box, at_corner, z_minus));
  EXPECT_TRUE(has_void(box, at_corner));
}

TEST(Throat, IsFourTouchingCollectorsAboveTheOutlet) {
  Geometry geometry;
  geometry.preset = Preset::throat;
  geometry.collector_diameter = 2.0;
  place_throat(geometry);
  EXPECT_EQ(geometry.box.size, (Vec3{2.0, 2.0, 3.0}));
  EXPECT_EQ(geometry.box.face(z_plus), FaceCondition::inlet);
  EXPECT_EQ(geometry.box.face(z_minus), FaceCondition::outlet);
  ASSERT_EQ(geometry.spheres.size(), 4U);
  const Vec3 axis{1.0, 1.0, 1.0};  // of the hole, in the plane of the centres
  for (const Sphere& collector : geometry.spheres) {
    EXPECT_DOUBLE_EQ(collector.center.z - collector.radius, 0.0);
    EXPECT_DOUBLE_EQ(norm(collector.center - axis) - collector.radius,
                     std::sqrt(2.0) - 1.0);
  }
  EXPECT_DOUBLE_EQ(surface_gap(geometry.box, geometry.spheres[0], geometry.spheres[1]),
                   0.0);
}

}  // namespace
}  // namespace colloid
