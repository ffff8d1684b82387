// What becomes of colloids placed by hand, favourable surfaces: see README.md beside
// this file.
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "constructed_run.h"
#include "core/constants.h"

namespace colloid {
namespace {

using cases::released_at;
using testing::Contains;
using testing::UnorderedElementsAre;

constexpr double kRadius = 3e-6;
constexpr double kGap = 20e-9;
const Vec3 kGrain{30e-6, 30e-6, 35e-6};
constexpr double kGrainRadius = 15e-6;
// The moment of contact is located to 1e-3 of the gap, from both sides.
constexpr double kLocated = 1.01e-3 * kGap;

double grain_gap(const Vec3& x) {
  return norm(x - kGrain) - kGrainRadius - kRadius;
}

// Counts of a run whose colloids all came from its start.
void expect_conserved(const Realisation& r, long released) {
  for (const SeriesRow& row : r.series) {
    EXPECT_EQ(row.mobile + row.retained + row.traversed, released) << row.time;
    EXPECT_EQ(row.first_layer + row.multilayer + row.wall_layer, row.retained);
  }
}

TEST(Fate, ArrestedOnTheGrainStraightBelow) {
  const Realisation r = cases::run_from(cases::one_grain_scene(),
                                        {{released_at({30e-6, 30e-6, 80e-6})}, {}});
  ASSERT_EQ(r.retained.size(), 1u);
  const RetainedColloid& c = r.retained[0];
  EXPECT_EQ(c.layer, Layer::first);
  EXPECT_EQ(c.mechanism, Mechanism::attachment_to_grain);
  EXPECT_THAT(c.partners, UnorderedElementsAre("grain 0"));
  EXPECT_NEAR(grain_gap(c.position), kGap, kLocated);
  // On the axis of a symmetric box: the pole.
  EXPECT_NEAR(c.alpha_deg, 90.0, 0.1);
  EXPECT_EQ(r.t1, c.time);
  EXPECT_EQ(r.alpha_deg, c.alpha_deg);
  EXPECT_EQ(c.contact_time, c.time);
  EXPECT_EQ(c.order, 1);
  expect_conserved(r, 1);
}

TEST(Fate, TraversesBesideTheGrain) {
  const Realisation r =
      cases::run_from(cases::one_grain_scene(), {{released_at({8e-6, 8e-6, 80e-6})}, {}});
  EXPECT_EQ(r.retained.size(), 0u);
  EXPECT_EQ(r.counts.traversed, 1);
  EXPECT_EQ(r.counts.mobile, 0);
  EXPECT_GT(r.last_traversal, 0.0);
  EXPECT_TRUE(std::isnan(r.t1));
  expect_conserved(r, 1);
}

TEST(Fate, BondsToTheDepositAndRollsOntoTheGrain) {
  Scene scene = cases::one_grain_scene();
  const double apart = kGrainRadius + kRadius + kGap;
  const Vec3 deposit = kGrain + Vec3{0.0, 0.0, apart};
  // Falls onto the deposit's shoulder.
  const Realisation r = cases::run_from(
      scene, {{released_at(deposit + Vec3{1.5e-6, 0.0, 12e-6})}, {deposit}});
  ASSERT_EQ(r.retained.size(), 1u);
  const RetainedColloid& c = r.retained[0];
  EXPECT_EQ(c.layer, Layer::first);
  EXPECT_EQ(c.mechanism, Mechanism::attachment_to_grain);
  EXPECT_THAT(c.partners, UnorderedElementsAre("grain 0", "colloid 1000"));
  EXPECT_LT(c.contact_time, c.time);
  EXPECT_EQ(r.t1, c.time);
  // It stayed on the deposit, and ended on the grain.
  EXPECT_NEAR(norm(c.position - deposit), 2.0 * kRadius + r.deterministic.back().second,
              1e-9 * kRadius + 1e-3 * kGap);
  EXPECT_NEAR(grain_gap(c.position), kGap, kLocated);
  // Bonded rows in between.
  long bonded = 0;
  for (const SeriesRow& row : r.series) {
    bonded += row.bonded;
  }
  EXPECT_GT(bonded, 0);
  expect_conserved(r, 1);
}

TEST(Fate, MobileColloidsThatTouchMoveAsOneAndAreRetainedTogether) {
  const Vec3 low{33e-6, 30e-6, 70e-6};
  const Vec3 n{0.6, 0.0, 0.8};
  const Vec3 high = low + n * (2.0 * kRadius + 0.999 * kGap);
  const Realisation r = cases::run_from(
      cases::one_grain_scene(), {{released_at(low, 0), released_at(high, 1)}, {}});
  ASSERT_EQ(r.retained.size(), 2u);
  const RetainedColloid& a = r.retained[0];
  const RetainedColloid& b = r.retained[1];
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.order, 1);
  EXPECT_EQ(b.order, 2);
  EXPECT_EQ(a.layer, Layer::first);
  EXPECT_EQ(b.layer, Layer::multilayer);
  EXPECT_EQ(b.mechanism, Mechanism::attachment_to_deposit);
  EXPECT_THAT(b.partners, UnorderedElementsAre("colloid " + std::to_string(a.colloid)));
  EXPECT_THAT(a.partners, Contains("grain 0"));
  EXPECT_LT(a.contact_time, a.time);
  // Rigid: their distance has not changed.
  EXPECT_NEAR(norm(a.position - b.position), norm(high - low), 1e-9 * kRadius);
  EXPECT_EQ(r.t1, a.time);
  expect_conserved(r, 2);
}

// A chain longer than half of the periodic width, its colloids released where they are in
// the box: one rigid body whichever face they touch through.
TEST(Fate, AChainThroughAPeriodicFaceIsRigidAndRestsInTheBox) {
  Scene scene = cases::one_grain_scene();
  const double width = 30e-6;
  scene.geometry.box.size.x = width;
  scene.geometry.box.faces[x_minus] = FaceCondition::periodic;
  scene.geometry.box.faces[x_plus] = FaceCondition::periodic;
  scene.geometry.spheres = {{{15e-6, 30e-6, 30e-6}, 8e-6}};
  constexpr int kMembers = 8;
  const double apart = 2.0 * kRadius + 0.999 * kGap;
  const Vec3 n{0.8, 0.0, 0.6};
  cases::Start start;
  for (int id = 0; id < kMembers; ++id) {
    Vec3 x = Vec3{17e-6, 30e-6, 46e-6} + n * (id * apart);
    x.x -= x.x < width ? 0.0 : width;
    start.bodies.push_back(released_at(x, id));
  }
  const Realisation r = cases::run_from(scene, start);
  ASSERT_EQ(r.retained.size(), static_cast<std::size_t>(kMembers));
  std::vector<Vec3> at(kMembers);
  for (const RetainedColloid& c : r.retained) {
    EXPECT_EQ(c.time, r.t1);
    EXPECT_GE(c.position.x, 0.0) << c.colloid;
    EXPECT_LT(c.position.x, width) << c.colloid;
    at[static_cast<std::size_t>(c.colloid)] = c.position;
  }
  Vec3 first;
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const Vec3 link = shortest(scene.geometry.box, at[k + 1], at[k]);
    first = k == 0 ? link : first;
    EXPECT_NEAR(norm(link), apart, 1e-9 * kRadius) << k;
    EXPECT_NEAR(norm(link - first), 0.0, 1e-8 * kRadius) << k;  // straight
  }
  // It turned on its way, or rigidity would show nothing: an image more than where it
  // belongs would be off by the turn times the width.
  const double turn = norm(first * (1.0 / apart) - n);
  std::printf("turned by %.3f\n", turn);
  EXPECT_GT(turn, 1e-3);
  expect_conserved(r, kMembers);
}

// With aggregates off the same two part, or at least do not move as one.
TEST(Fate, MobileColloidsStayTwoWhereAggregatesAreOff) {
  Scene scene = cases::one_grain_scene();
  scene.aggregates = false;
  const Vec3 low{45e-6, 30e-6, 70e-6};
  const Vec3 high = low + Vec3{0.6, 0.0, 0.8} * (2.0 * kRadius + 0.999 * kGap);
  const Realisation r =
      cases::run_from(scene, {{released_at(low, 0), released_at(high, 1)}, {}});
  double least = 1.0;
  double most = 0.0;
  for (const Frame& frame : r.frames) {
    if (frame.colloids.size() == 2) {
      const double d = norm(frame.colloids[0].position - frame.colloids[1].position);
      least = std::min(least, d);
      most = std::max(most, d);
    }
  }
  EXPECT_GT(least, 2.0 * kRadius);
  EXPECT_GT(most, 2.0 * kRadius + 2.0 * kGap);
}

TEST(Fate, ThreeBondsHold) {
  // A triangle of deposit, and weight that brings the colloid into its dimple.
  std::vector<Vec3> deposit;
  const double ring = 3.6e-6;
  for (int k = 0; k < 3; ++k) {
    const double angle = 0.3 + 2.0 * kPi / 3.0 * k;
    deposit.push_back(
        {18e-6 + ring * std::cos(angle), 18e-6 + ring * std::sin(angle), 60e-6});
  }
  Scene scene = cases::one_grain_scene();
  scene.geometry.spheres[0].center = {45e-6, 45e-6, 20e-6};
  scene.geometry.spheres[0].radius = 10e-6;
  scene.colloids->density = 2000.0;
  scene.gravity = {0.0, 0.0, -1000.0};
  const Realisation r =
      cases::run_from(scene, {{released_at({18.3e-6, 18.2e-6, 75e-6})}, deposit});
  ASSERT_EQ(r.retained.size(), 1u);
  const RetainedColloid& c = r.retained[0];
  EXPECT_EQ(c.layer, Layer::multilayer);
  EXPECT_EQ(c.mechanism, Mechanism::attachment_to_deposit);
  EXPECT_THAT(c.partners,
              UnorderedElementsAre("colloid 1000", "colloid 1001", "colloid 1002"));
  EXPECT_TRUE(std::isnan(r.t1));
  EXPECT_TRUE(std::isnan(c.alpha_deg));
  for (const Vec3& d : deposit) {
    EXPECT_NEAR(norm(c.position - d), 2.0 * kRadius + kGap, kLocated);
  }
  expect_conserved(r, 1);
}

// Weight sideways brings the colloid to the wall x-.
Scene wall_scene(Walls walls) {
  Scene scene = cases::one_grain_scene();
  scene.geometry.spheres[0].center = {45e-6, 45e-6, 20e-6};
  scene.geometry.spheres[0].radius = 10e-6;
  scene.walls = walls;
  scene.colloids->density = 2000.0;
  scene.gravity = {-30.0, 0.0, 0.0};
  return scene;
}

TEST(Fate, AdhesiveWallHoldsWithoutAngleOrFirstRetention) {
  const Realisation r = cases::run_from(wall_scene(Walls::adhesive),
                                        {{released_at({5e-6, 15e-6, 80e-6})}, {}});
  ASSERT_EQ(r.retained.size(), 1u);
  const RetainedColloid& c = r.retained[0];
  EXPECT_EQ(c.layer, Layer::wall);
  EXPECT_EQ(c.mechanism, Mechanism::attachment_to_wall);
  EXPECT_THAT(c.partners, UnorderedElementsAre("wall x-"));
  EXPECT_TRUE(std::isnan(c.alpha_deg));
  EXPECT_TRUE(std::isnan(r.t1));
  EXPECT_NEAR(c.position.x - kRadius, kGap, kLocated);
  EXPECT_EQ(r.series.back().wall_layer, 1);
  expect_conserved(r, 1);
}

TEST(Fate, SlidesAlongAnInertWallAndTraverses) {
  const Realisation r = cases::run_from(wall_scene(Walls::inert),
                                        {{released_at({5e-6, 15e-6, 80e-6})}, {}});
  EXPECT_EQ(r.retained.size(), 0u);
  EXPECT_EQ(r.counts.traversed, 1);
  double nearest = 1.0;
  for (const Frame& frame : r.frames) {
    for (const ColloidRecord& c : frame.colloids) {
      nearest = std::min(nearest, c.position.x - kRadius);
    }
  }
  // It did touch, and pressed no deeper.
  EXPECT_NEAR(nearest, kGap, kLocated);
  expect_conserved(r, 1);
}

}  // namespace
}  // namespace colloid
