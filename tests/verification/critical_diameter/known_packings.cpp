// Packings whose critical diameter has a closed form.
//
// Reference  geometry, written out at each test; none of it is computed by the solver.
// Tolerance  the search states its error, asked to be 1e-9 of the smallest diameter;
// value
//            and reference also carry rounding, some 1e-15.  So: value <= reference <=
//            value + error, each to 1e-13 of the reference.
#include <cmath>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "observe/critical_diameter.h"
#include "packings.h"

namespace colloid {
namespace {

constexpr auto kOpen = FaceCondition::symmetry;
constexpr auto kWall = FaceCondition::wall;

void expect_exact(const CriticalDiameter& found, double exact, double diameter) {
  EXPECT_FALSE(found.blocked);
  EXPECT_LE(found.error, 1e-9 * diameter * (1.0 + 1e-12));
  EXPECT_LE(found.value, exact + 1e-13 * diameter);
  EXPECT_GE(found.value + found.error, exact - 1e-13 * diameter);
}

// A hexagonal layer is periodic in a rectangle d x sqrt(3) d; its pores are triangles.
TEST(KnownPackings, ThreeTouchingSpheres) {
  const double d = 2.0;
  Packing layer{periodic_box({d, std::sqrt(3.0) * d, 4.0 * d}), {}};
  layer.spheres = {{{0.3, 0.2, 1.1}, 0.5 * d},
                   {{0.3 + 0.5 * d, 0.2 + 0.5 * std::sqrt(3.0) * d, 1.1}, 0.5 * d}};
  const CriticalDiameter found = critical_diameter(layer.box, layer.spheres);
  expect_exact(found, (2.0 / std::sqrt(3.0) - 1.0) * d, d);
  EXPECT_EQ(found.surfaces.size(), 3U);
  EXPECT_NEAR(found.bottleneck.z, 1.1, 1e-4 * d);
}

TEST(KnownPackings, FourSpheresInASquareAndTheEmptyThroat) {
  const Packing throat = empty_throat();
  const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
  expect_exact(found, (std::sqrt(2.0) - 1.0) * kCollector, kCollector);
  EXPECT_NEAR(found.value, 40.013e-6, 0.0005e-6);  // physics of the reference scene
  EXPECT_NEAR(norm(found.bottleneck - 0.5 * Vec3{1, 1, 1} * kCollector), 0.0, 1e-8);
  EXPECT_EQ(found.surfaces.size(), 4U);
}

TEST(KnownPackings, QuarterOfTheThroatBetweenSymmetryFaces) {
  const double half = 0.5 * kCollector;
  const Packing quarter{flow_box({half, half, 3.0 * half}, kOpen),
                        {{{0, 0, half}, half}}};
  const CriticalDiameter found = critical_diameter(quarter.box, quarter.spheres);
  expect_exact(found, (std::sqrt(2.0) - 1.0) * kCollector, kCollector);
  EXPECT_THAT(found.surfaces, testing::SizeIs(1));
}

// The middle one of three spheres that touch each other and a plane, the outer two equal:
// their points on the plane are d/2 and sqrt(d d_c) apart, so d_c = d/4.
TEST(KnownPackings, TwoTouchingSpheresOnAPlane) {
  const double d = 1.0;
  Packing scene{flow_box({d, 0.5 * d, 3.0 * d}, kOpen), {}};
  scene.box.faces[y_minus] =
      kWall;  // the plane; at the other side they touch the box's face
  scene.spheres = {{{0, 0.5 * d, 1.5 * d}, 0.5 * d}, {{d, 0.5 * d, 1.5 * d}, 0.5 * d}};
  const CriticalDiameter found = critical_diameter(scene.box, scene.spheres);
  expect_exact(found, 0.25 * d, d);
  EXPECT_THAT(found.surfaces, testing::UnorderedElementsAre(
                                  SurfaceName{SurfaceName::Kind::sphere, 0},
                                  SurfaceName{SurfaceName::Kind::sphere, 1},
                                  SurfaceName{SurfaceName::Kind::wall, y_minus}));
}

TEST(KnownPackings, SimpleCubicAndBodyCentredLattices) {
  const double d = 1.0;
  const Packing simple{periodic_box({d, d, d}), {{{0.2, 0.3, 0.1}, 0.5 * d}}};
  const double a = 2.0 * d / std::sqrt(3.0);
  const Packing centred{periodic_box({a, a, a}),
                        {{{0, 0, 0}, 0.5 * d}, {{0.5 * a, 0.5 * a, 0.5 * a}, 0.5 * d}}};
  for (int axis = 0; axis < 3; ++axis) {
    CriticalDiameterOptions along;
    along.flow_axis = axis;
    expect_exact(critical_diameter(simple.box, simple.spheres, along),
                 (std::sqrt(2.0) - 1.0) * d, d);
    // The window is a triangle of sides d, d, a: circumradius d d / (2 height over a).
    const double height = std::sqrt(d * d - 0.25 * a * a);
    const CriticalDiameter found = critical_diameter(centred.box, centred.spheres, along);
    expect_exact(found, 2.0 * (d * d / (2.0 * height)) - d, d);
    EXPECT_NEAR(found.value / d, 0.224745, 5e-7);
  }
}

TEST(KnownPackings, RectangularDucts) {
  for (const double ratio : {1.0, 1.3, 2.0, 7.0, 40.0}) {
    const Packing duct{flow_box({1e-5, ratio * 1e-5, 3e-5}, kWall), {}};
    expect_exact(critical_diameter(duct.box, {}), 1e-5, 1e-5);
    const Packing turned = permuted(duct);
    expect_exact(critical_diameter(turned.box, {}), 1e-5, 1e-5);
  }
}

// A sphere fills a square duct but for its corners, or but for the middle of two sides.
TEST(KnownPackings, NarrowGapsAroundASphereInADuct) {
  const double w = 1.0;
  for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const double a = std::sqrt(0.5) * w * (1.0 - gap);
    Packing duct{flow_box({w, w, 3.0 * w}, kWall), {{{0.5 * w, 0.5 * w, 1.5 * w}, a}}};
    // In a corner at (r, r): sqrt(2) (w/2 - r) = a + r.
    const double corner = (std::sqrt(0.5) * w - a) / (1.0 + std::sqrt(2.0));
    expect_exact(critical_diameter(duct.box, duct.spheres), 2.0 * corner, w);
    // Two sides are planes of symmetry: at (0, r), hypot(w/2, w/2 - r) = a + r.
    duct.box.faces[x_minus] = duct.box.faces[x_plus] = kOpen;
    const double side = (0.5 * w * w - a * a) / (2.0 * a + w);
    expect_exact(critical_diameter(duct.box, duct.spheres), 2.0 * side, w);
  }
}

TEST(KnownPackings, NoSurfaceLetsEverythingPass) {
  const Packing nothing{flow_box({1, 1, 1}, kOpen), {}};
  EXPECT_TRUE(std::isinf(critical_diameter(nothing.box, {}).value));
}

}  // namespace
}  // namespace colloid
