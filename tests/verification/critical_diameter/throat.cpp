// The reference throat at its extremes, and the use of an earlier result.
//
// Reference  closed forms, and the definition itself: the path is walked in small steps.
#include <cmath>

#include "gtest/gtest.h"
#include "observe/clearance.h"
#include "observe/critical_diameter.h"
#include "packings.h"

namespace colloid {
namespace {

constexpr double kHole = (1.41421356237309504880 - 1.0) * kCollector;

// The path is an open polygon from inlet to outlet; its clearance is sampled, and so is
// at least the stated one.
void expect_path_to_keep(const Packing& packing, const CriticalDiameter& found) {
  ASSERT_GE(found.path.size(), 2U);
  EXPECT_DOUBLE_EQ(found.path.front().z, packing.box.size.z);
  EXPECT_DOUBLE_EQ(found.path.back().z, 0.0);
  for (std::size_t i = 0; i + 1 < found.path.size(); ++i) {
    for (int step = 0; step <= 50; ++step) {
      const Vec3 point =
          found.path[i] + (step / 50.0) * (found.path[i + 1] - found.path[i]);
      EXPECT_GE(2.0 * clearance(packing.box, packing.spheres, point).distance,
                found.value - 1e-13 * kColloid);
    }
  }
  EXPECT_NEAR(2.0 * clearance(packing.box, packing.spheres, found.bottleneck).distance,
              found.value, 1e-13 * kColloid);
}

// A sphere in the middle of the hole, one per cent smaller or larger than it: what passes
// beside it touches it and, by symmetry, is on the line from it to the middle of a wall.
TEST(Throat, ColloidOfTheSizeOfTheHole) {
  for (const double scale : {0.99, 1.0, 1.01}) {
    Packing throat = empty_throat();
    const double d = kCollector;
    const double a = 0.5 * scale * kHole;
    throat.spheres.push_back({{0.5 * d, 0.5 * d, 0.5 * d}, a});
    // On the line x = t, y = d/2, z = d/2 towards the wall x = 0: gap to the colloid
    // d/2 - t - a falls with t, gap to the collectors sqrt(t^2 + d^2/4) - d/2 rises,
    // the gap to the wall is t.
    const auto radius = [&](double t) {
      return std::min({t, 0.5 * d - t - a, std::hypot(t, 0.5 * d) - 0.5 * d});
    };
    double low = 0.0;
    double high = 0.5 * d;
    for (int i = 0; i < 200; ++i) {
      const double t1 = low + (high - low) / 3.0;
      const double t2 = high - (high - low) / 3.0;
      (radius(t1) < radius(t2) ? low : high) = radius(t1) < radius(t2) ? t1 : t2;
    }
    const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
    const double exact = 2.0 * radius(0.5 * (low + high));
    EXPECT_NEAR(found.value, exact, found.error + 1e-12 * kHole);
    EXPECT_LE(found.error, 1e-9 * kHole);
    expect_path_to_keep(throat, found);
  }
}

TEST(Throat, ColloidPassesOnlyIfItIsSmallerThanTheHole) {
  const Packing throat = empty_throat();
  const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
  EXPECT_GT(found.value, 0.99 * kHole);
  EXPECT_LT(found.value + found.error, 1.01 * kHole);
  expect_path_to_keep(throat, found);
}

// Four colloids in a square in the throat's plane, touching each other and the
// collectors: the hole among them stays open, so l_c is at least that; beside them it may
// be wider.
TEST(Throat, TouchingClusterOfFourAcrossIt) {
  Packing throat = empty_throat();
  const double a = 0.5 * kHole / (1.0 + std::sqrt(2.0));  // touches the collectors too
  const double c = 0.5 * kCollector;
  for (int i = 0; i < 4; ++i) {
    const double x = i % 2 == 0 ? -1.0 : 1.0;
    const double y = i / 2 == 0 ? -1.0 : 1.0;
    throat.spheres.push_back({{c + x * a, c + y * a, c}, a});
  }
  const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
  EXPECT_FALSE(found.blocked);
  EXPECT_GE(found.value, 2.0 * (std::sqrt(2.0) - 1.0) * a * (1.0 - 1e-9));
  expect_path_to_keep(throat, found);
}

TEST(Throat, BlockedWhenEverySurfaceTouches) {
  // A sphere whose section with the plane of the throat covers the square exactly up to
  // its corners: it closes the throat, to rounding, at a single ring of points.
  for (const double slack : {-1e-6, 0.0, 1e-15}) {
    Packing throat = empty_throat();
    throat.spheres.clear();
    const double c = 0.5 * kCollector;
    throat.spheres.push_back({{c, c, c}, std::sqrt(2.0) * c * (1.0 - slack)});
    const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
    EXPECT_TRUE(found.blocked) << slack;
    EXPECT_EQ(found.value, 0.0);
    EXPECT_LE(found.error, 2e-9 * kCollector);
  }
  // Opened by 1e-6: a corner of the square lets a sphere of known radius pass.
  Packing throat = empty_throat();
  throat.spheres.clear();
  const double c = 0.5 * kCollector;
  const double a = std::sqrt(2.0) * c * (1.0 - 1e-6);
  throat.spheres.push_back({{c, c, c}, a});
  const CriticalDiameter found = critical_diameter(throat.box, throat.spheres);
  const double r = (std::sqrt(2.0) * c - a) / (1.0 + std::sqrt(2.0));
  EXPECT_FALSE(found.blocked);
  EXPECT_NEAR(found.value, 2.0 * r, found.error + 1e-13 * c);
}

TEST(Throat, SpheresTangentToTheWallsToRounding) {
  Packing throat = empty_throat();
  const double a = 0.5 * kColloid;
  const double d = kCollector;
  for (const double shift : {-1e-16, 0.0, 1e-16}) {
    Packing shifted = throat;
    for (int i = 0; i < 4; ++i) {
      shifted.spheres.push_back({{a + shift * d, (0.2 + 0.2 * i) * d, 0.52 * d}, a});
    }
    const CriticalDiameter found = critical_diameter(shifted.box, shifted.spheres);
    EXPECT_NEAR(found.value, kHole, 1e-9 * d);  // the hole itself is free
  }
}

// Deposits that grow: the old result gives the same answer as none, and l_c never rises.
TEST(Throat, GrowingDepositOnlyNarrowsIt) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Packing full = clogging_throat(100, seed);
    Packing throat = empty_throat();
    CriticalDiameter before = critical_diameter(throat.box, throat.spheres);
    double last = before.value + before.error;
    for (std::size_t i = throat.spheres.size(); i < full.spheres.size(); ++i) {
      throat.spheres.push_back(full.spheres[i]);
      CriticalDiameterOptions options;
      options.before = &before;
      const CriticalDiameter found =
          critical_diameter(throat.box, throat.spheres, options);
      EXPECT_LE(found.value, last);
      EXPECT_LE(found.error, 1e-9 * kCollector);
      if (i % 10 == 0) {
        const CriticalDiameter fresh = critical_diameter(throat.box, throat.spheres);
        EXPECT_NEAR(found.value, fresh.value, found.error + fresh.error);
        expect_path_to_keep(throat, fresh);
      }
      last = found.value + found.error;
      before = found;
    }
    EXPECT_LT(last, 0.5 * kHole);
  }
}

}  // namespace
}  // namespace colloid
