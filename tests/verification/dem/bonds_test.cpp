// Colloids that stick to each other.
#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

constexpr double kGap = 5e-9;  // below the gap of contact, 6 nm
constexpr double kLength = 2.0 * kRadius + kGap;

/// A retained colloid in the middle, and a free one at `angle` from the x axis.
void add_pair(Dem& dem, double angle) {
  dem.add({0, kMiddle, {}, {}, true});
  dem.add({1,
           kMiddle + Vec3{kLength * std::cos(angle), kLength * std::sin(angle), 0.0},
           {},
           {}});
}

// Reference  rolling without slip on a sphere at rest, v = length w', spin = 2v/length,
//            under a force along x: (drag + 4 torsion/length^2) length w' = -F sin w, so
//            tan(w/2) falls as exp(-rate t).
// Tolerance  inertia delays by tau = 1.4 m / (drag + ..): the angle is late by up to
//            rate tau; bonds give by F/k < 1e-4 of the radius.  Twice as slow: half the
//            error, which is what makes it the inertia.
TEST(DemBonds, RollsRoundARetainedColloid) {
  const double resistance = kDrag + 4.0 * kTorsion / (kLength * kLength);
  for (const double push : {1e-9, 5e-10}) {
    Dem dem(bonding(), {});
    add_pair(dem, 2.0);
    const double rate = push / (resistance * kLength);
    const double delay = rate * 1.4 * kMass / resistance;
    double time = 0.0;
    for (int i = 0; i < 4; ++i) {
      const DemStep taken =
          dem.advance(0.5 / rate, {stokes_drag(1, {}, {push, 0.0, 0.0})});
      if (i == 0) {
        ASSERT_EQ(taken.events.size(), 1U);
        EXPECT_EQ(taken.events[0].kind, DemEvent::Kind::touched_retained);
        EXPECT_EQ(taken.events[0].colloid, 1);
      }
      time += 0.5 / rate;
      const DemState free = dem.states().at(1);
      const Vec3 e = free.position - kMiddle;
      const double angle = 2.0 * std::atan(std::tan(1.0) * std::exp(-rate * time));
      EXPECT_NEAR(std::atan2(e.y, e.x), angle, 1.2 * delay);
      EXPECT_NEAR(norm(e), kLength, 1e-4 * kRadius);
      EXPECT_EQ(e.z, 0.0);
      EXPECT_NEAR(free.spin.z, -2.0 * push * std::sin(angle) / (resistance * kLength),
                  4.0 * rate * delay);
    }
  }
}

TEST(DemBonds, PermanentOnesHoldAtTheRear) {
  DemOptions options = bonding();
  const double pull_off = options.surfaces.colloid.pull_off;
  ASSERT_GT(pull_off, 1e-10);
  Dem dem(options, {});
  add_pair(dem, 1e-3);
  const double pull = 20.0 * pull_off;
  for (int i = 0; i < 20; ++i) {
    dem.advance(1e-4, {stokes_drag(1, {}, {pull, 0.0, 0.0})});
  }
  ASSERT_EQ(dem.bonds().size(), 1U);
  const DemBond bond = dem.bonds()[0];
  EXPECT_FALSE(bond.rigid);
  EXPECT_NEAR(bond.tension / pull, 1.0, 1e-6);  // at rest: equilibrium
  EXPECT_GE(bond.largest_tension, bond.tension * (1.0 - 1e-12));
  EXPECT_EQ(dem.bonds_broken(), 0);
  // It still falls towards the rear as exp(-rate t), rate t = 4.6; the delay by inertia,
  // rate tau = 0.014 of that, changes what is left by 7 %.
  const double resistance = kDrag + 4.0 * kTorsion / (kLength * kLength);
  const double left = 1e-3 * std::exp(-2e-3 * pull / (resistance * kLength));
  EXPECT_NEAR(norm(dem.states().at(1).velocity) / (left * pull / resistance), 1.0, 0.1);
}

// Reference  equilibrium: the tension is the pull.
// Tolerance  raised by 1 % at a time; of that a free spring overshoots by all, so the
// bond
//            breaks between the pull-off less and plus 1 %.
TEST(DemBonds, BreakableOnesBreakAtThePullOff) {
  DemOptions options = bonding();
  options.permanent_bonds = false;
  const double pull_off = options.surfaces.colloid.pull_off;
  Dem dem(options, {});
  add_pair(dem, 0.0);
  for (int percent = 50; percent < 120; ++percent) {
    const double pull = 0.01 * percent * pull_off;
    const DemStep taken = dem.advance(2e-5, {stokes_drag(1, {}, {pull, 0.0, 0.0})});
    if (dem.bonds_broken() > 0) {
      EXPECT_GE(percent, 99);
      EXPECT_LE(percent, 101);
      ASSERT_EQ(taken.events.size(), 1U);  // and it does not bond again at once
      EXPECT_EQ(taken.events[0].kind, DemEvent::Kind::bond_broken);
      dem.advance(2e-4, {stokes_drag(1, {}, {pull, 0.0, 0.0})});
      EXPECT_TRUE(dem.bonds().empty());
      EXPECT_NEAR(dem.states().at(1).velocity.x, pull / kDrag, 1e-6 * pull / kDrag);
      // Driven back slowly, so that it does not rebound, it bonds again.
      const DemStep back =
          dem.advance(1.2e-2, {stokes_drag(1, {}, {-0.02 * pull, 0.0, 0.0})});
      ASSERT_EQ(back.events.size(), 1U);
      EXPECT_EQ(back.events[0].kind, DemEvent::Kind::touched_retained);
      return;
    }
  }
  FAIL() << "the bond holds more than the pull-off";
}

// Reference  opposite forces across a rigid pair turn it at F L / (drag L^2/2 + 2
// torsion). Tolerance  the springs across and about give by F/(k a), 1e-4 rad: second
// order in the
//            rate.  What is left of the start after 20 relaxation times: 2e-9.
TEST(DemBonds, OfMobileColloidsMakeARigidBody) {
  Dem dem(bonding(), {});
  dem.add({0, kMiddle - Vec3{0.5 * kLength, 0.0, 0.0}, {}, {}});
  dem.add({1, kMiddle + Vec3{0.5 * kLength, 0.0, 0.0}, {}, {}});
  const double push = 2e-10;
  const double rate = push * kLength / (0.5 * kDrag * kLength * kLength + 2.0 * kTorsion);
  double turned = 0.0;
  for (int i = 0; i < 40; ++i) {  // the forces turn with the pair
    const std::vector<DemState> s = dem.states();
    const Vec3 e = (s.at(1).position - s.at(0).position) * (1.0 / kLength);
    const Vec3 across{-push * e.y, push * e.x, 0.0};
    dem.advance(1e-5, {stokes_drag(0, {}, -across), stokes_drag(1, {}, across)});
    turned = std::atan2(e.y, e.x);
  }
  ASSERT_EQ(dem.bonds().size(), 1U);
  EXPECT_TRUE(dem.bonds()[0].rigid);
  EXPECT_GT(turned, 1e-4);
  const std::vector<DemState> s = dem.states();
  for (const DemState& state : s) {
    EXPECT_NEAR(state.spin.z / rate, 1.0, 1e-3);
    EXPECT_NEAR(norm(state.velocity) / (0.5 * kLength * rate), 1.0, 1e-3);
  }
  EXPECT_NEAR(norm(s[1].position - s[0].position), kLength, 1e-4 * kRadius);
  EXPECT_NEAR(norm(s[0].position + s[1].position - 2.0 * kMiddle), 0.0, 1e-16);
  EXPECT_EQ(dem.aggregate(0), (std::vector<int>{0, 1}));
}

// Reference  a torque on one of them turns both, across the pair as above, about its axis
//            at T / (2 torsion).
// Tolerance  as above: 1e-3.
TEST(DemBonds, OfMobileColloidsNeitherBendNorTwist) {
  const double torque = 1e-15;
  const double about_axis = torque / (2.0 * kTorsion);
  const double across = torque / (0.5 * kDrag * kLength * kLength + 2.0 * kTorsion);
  for (const Vec3& axis : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 1.0}}) {
    Dem dem(bonding(), {});
    dem.add({0, kMiddle - Vec3{0.5 * kLength, 0.0, 0.0}, {}, {}});
    dem.add({1, kMiddle + Vec3{0.5 * kLength, 0.0, 0.0}, {}, {}});
    DemLoad turned = stokes_drag(0, {});
    turned.torque = torque * axis;
    for (int i = 0; i < 10; ++i) {
      dem.advance(4e-5, {turned, stokes_drag(1, {})});
    }
    const double rate = axis.x > 0.0 ? about_axis : across;
    for (const DemState& state : dem.states()) {
      EXPECT_NEAR(dot(state.spin, axis) / rate, 1.0, 1e-3);
    }
  }
}

TEST(DemBonds, JoinNoMobileColloidsWithoutAggregates) {
  DemOptions options = bonding();
  options.surfaces.rules.aggregates = false;
  Dem dem(options, {});
  dem.add({0, kMiddle, {}, {}});
  dem.add({1, kMiddle + Vec3{kLength, 0.0, 0.0}, {}, {}});
  EXPECT_TRUE(dem.advance(1e-6, {}).events.empty());
  dem.hold(0);  // retained: now they do
  const DemStep taken = dem.advance(1e-6, {});
  ASSERT_EQ(taken.events.size(), 1U);
  EXPECT_EQ(taken.events[0].kind, DemEvent::Kind::touched_retained);
}

}  // namespace
}  // namespace colloid::dem_test
