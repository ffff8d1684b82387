// Arrest on grains and adhesive walls.
// Reference  a colloid driven at constant speed v has crossed the way to the gap of
//            contact after way / v.
// Tolerance  one sub-step in time, v times the sub-step in position: arrest is looked for
//            at the end of each.
#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

constexpr double kGrain = 4e-5;

DemOptions attaching() {
  DemOptions options = inert();
  options.surfaces.rules.grains_attach = true;
  return options;
}

TEST(DemArrest, HoldsAColloidAtTheGapOfContact) {
  const double way = 2e-8;
  for (const double step : {5e-8, 2.5e-8}) {
    DemOptions options = attaching();
    options.step = step;
    const double gap = options.surfaces.rules.grain_gap;
    ASSERT_GT(gap, 5e-9);
    Dem dem(options, {{{1e-5, 1e-5, 1e-5}, 5e-6}, {kMiddle, kGrain}});
    const double distance = kGrain + kRadius + gap;
    dem.add({5, kMiddle - Vec3{distance + way, 0.0, 0.0}, {kSpeed, 0.0, 0.0}, {}});
    const DemLoad load = stokes_drag(5, {kSpeed, 0.0, 0.0});
    const DemStep taken = dem.advance(8e-5, {load});
    ASSERT_EQ(taken.events.size(), 1U);
    const DemEvent event = taken.events[0];
    EXPECT_EQ(event.kind, DemEvent::Kind::touched_grain);
    EXPECT_EQ(event.colloid, 5);
    EXPECT_EQ(event.other, 1);
    EXPECT_GE(event.time, way / kSpeed - 1e-12);
    EXPECT_LE(event.time, way / kSpeed + step + 1e-12);
    const DemState held = dem.states().at(0);
    EXPECT_TRUE(held.held);
    EXPECT_EQ(held.velocity, Vec3{});
    const double at = norm(held.position - kMiddle) - distance;
    EXPECT_LE(at, 1e-18);
    EXPECT_GE(at, -1.01 * kSpeed * step);
    const DemStep later = dem.advance(8e-5, {load});
    EXPECT_EQ(dem.states().at(0).position, held.position);
    EXPECT_TRUE(later.events.empty());
    EXPECT_TRUE(later.means.empty());
  }
}

/// Whether a colloid pressed on a grain by `push` sticks.
bool sticks(const DemOptions& options, double push) {
  Dem dem(options, {{kMiddle, kGrain}});
  const double distance = kGrain + kRadius + 0.5 * options.surfaces.rules.grain_gap;
  dem.add({0, kMiddle + Vec3{0.0, distance, 0.0}, {}, {}});
  dem.advance(1e-4, {stokes_drag(0, {}, {0.0, -push, 0.0})});
  return dem.states().at(0).held;
}

TEST(DemArrest, OverABarrierNeedsThePush) {
  SurfacePair pair = grain_pair();
  pair.electrolyte.ionic_strength = 1.0;  // mol/m^3: a barrier
  DemOptions options = inert();
  options.surfaces = surface_model(pair);
  options.surfaces.rules.colloids_attach = false;
  ASSERT_FALSE(options.surfaces.rules.grains_attach);
  const double repulsion = options.surfaces.rules.grain_repulsion;
  ASSERT_GT(repulsion, 1e-11);
  ASSERT_LT(repulsion, 1e-7);
  EXPECT_FALSE(sticks(options, 0.99 * repulsion));
  EXPECT_TRUE(sticks(options, 1.01 * repulsion));
}

TEST(DemArrest, OnWallsIfTheyAreAdhesive) {
  for (const bool adhesive : {true, false}) {
    DemOptions options = inert();
    options.surfaces.rules.walls_attach = adhesive;
    Dem dem(options, {});
    dem.add({0, {1e-4, 2e-4 - kRadius - 2e-8, 1e-4}, {}, {}});
    const DemStep taken = dem.advance(2e-4, {stokes_drag(0, {0.0, kSpeed, 0.0})});
    EXPECT_EQ(dem.states().at(0).held, adhesive);
    ASSERT_EQ(taken.events.size(), adhesive ? 1U : 0U);
    if (adhesive) {
      EXPECT_EQ(taken.events[0].kind, DemEvent::Kind::touched_wall);
      EXPECT_EQ(taken.events[0].other, y_plus);
    }
  }
}

TEST(DemArrest, OfOneArrestsItsAggregate) {
  DemOptions options = attaching();
  options.surfaces.rules.colloids_attach = true;
  Dem dem(options, {{kMiddle, kGrain}});
  const double distance = kGrain + kRadius + options.surfaces.rules.grain_gap + 1e-8;
  const double pair = 2.0 * kRadius + 0.9 * options.surfaces.rules.colloid_gap;
  for (int id = 0; id < 3; ++id) {
    dem.add(
        {id, kMiddle + Vec3{0.0, 0.0, distance + id * pair}, {0.0, 0.0, -kSpeed}, {}});
  }
  std::vector<DemLoad> loads;
  for (int id = 0; id < 3; ++id) {
    loads.push_back(stokes_drag(id, {0.0, 0.0, -kSpeed}));
  }
  const DemStep taken = dem.advance(8e-5, loads);
  std::vector<DemEvent::Kind> kinds;
  for (const DemEvent& event : taken.events) {
    kinds.push_back(event.kind);
  }
  using Kind = DemEvent::Kind;
  EXPECT_EQ(kinds, (std::vector<Kind>{Kind::touched_mobile, Kind::touched_mobile,
                                      Kind::touched_grain, Kind::arrested_with,
                                      Kind::arrested_with}));
  for (const DemState& state : dem.states()) {
    EXPECT_TRUE(state.held);
  }
  EXPECT_EQ(dem.aggregate(2), (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace colloid::dem_test
