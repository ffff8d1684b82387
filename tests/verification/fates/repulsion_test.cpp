// Colloids and grains that repel each other: straining, pushes, bonds that break.  See
// README.md beside this file.
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "constructed_run.h"
#include "core/constants.h"
#include "physics/regime_numbers.h"
#include "scene/throat.h"
#include "tiers/surface_model.h"

namespace colloid {
namespace {

using cases::released_at;
using testing::Contains;

constexpr double kCollector = 96.6e-6;
const double kHole = (std::sqrt(2.0) - 1.0) * kCollector;

// The throat at an ionic strength where colloid and grain repel, one colloid.
Scene repelling_throat(double diameter) {
  Scene scene;
  scene.geometry.preset = Preset::throat;
  scene.geometry.collector_diameter = kCollector;
  place_throat(scene.geometry);
  scene.drive.inlet_velocity = 0.5e-3;
  scene.colloids = Colloids{};
  scene.colloids->diameter = diameter;
  scene.colloids->volume_fraction = 1e-12;
  scene.surface.ionic_strength = 10.0;
  // Enough for the push of a wedge, several times the drag, not to overcome it.
  scene.surface.zeta_colloid = -60e-3;
  scene.surface.zeta_grain = -60e-3;
  scene.gravity = {};
  scene.duration = 5.0;
  scene.fidelity.cells_per_colloid = 12.0;
  return scene;
}

SurfaceModel contacts_of(const Scene& scene) {
  return make_surface_model(
      scene, stokes_drag(scene.fluid.viscosity, 0.5 * scene.colloids->diameter,
                         *scene.drive.inlet_velocity));
}

Realisation drop_into(const Scene& scene, double aside) {
  const double top = scene.geometry.box.size.z - 0.5 * scene.colloids->diameter;
  const double middle = 0.5 * kCollector;
  return cases::run_from(scene,
                         {{released_at({middle + aside, middle, top - 1e-6})}, {}});
}

TEST(Straining, HoldsAColloidLargerThanTheHole) {
  const Scene scene = repelling_throat(1.01 * kHole);
  const SurfaceModel contacts = contacts_of(scene);
  ASSERT_FALSE(contacts.rules.grains_attach);
  const double a = 0.5 * scene.colloids->diameter;
  for (double aside : {0.0, 4e-6}) {
    const Realisation r = drop_into(scene, aside);
    ASSERT_EQ(r.retained.size(), 1u) << aside;
    const RetainedColloid& c = r.retained[0];
    EXPECT_EQ(c.mechanism, Mechanism::straining);
    EXPECT_EQ(c.layer, Layer::first);
    EXPECT_EQ(c.partners.size(), 4u);
    // It rests where a sphere with its standoff touches all four grains: (z - z_0)^2 =
    // (R + a + gap)^2 - (d_c/sqrt 2)^2.
    const double reach = 0.5 * kCollector + a + contacts.rules.grain_gap;
    const double height = std::sqrt(reach * reach - 0.5 * kCollector * kCollector);
    std::printf("aside %g: height %.6e, exact %.6e\n", aside,
                c.position.z - 0.5 * kCollector, height);
    EXPECT_NEAR(c.position.z - 0.5 * kCollector, height, 1e-3 * height);
    EXPECT_NEAR(c.position.x, 0.5 * kCollector, 1e-3 * a);
    EXPECT_NEAR(c.position.y, 0.5 * kCollector, 1e-3 * a);
    // By coming to rest, not by the push of the wedge: that takes 10 a/U.
    EXPECT_LT(r.t1, scene.duration);
    EXPECT_GT(r.t1, 10.0 * a / *scene.drive.inlet_velocity);
  }
}

TEST(Straining, LetsAColloidSmallerThanTheHolePass) {
  const Scene scene = repelling_throat(0.99 * kHole);
  ASSERT_LT(contacts_of(scene).rules.grain_gap, 0.005 * kHole);
  for (double aside : {0.0, 4e-6}) {
    const Realisation r = drop_into(scene, aside);
    EXPECT_EQ(r.retained.size(), 0u);
    EXPECT_EQ(r.counts.traversed, 1);
  }
}

// Where colloid and grain attract, the same colloid sticks to the grain that it touches.
TEST(Straining, IsAttachmentWhereTheSurfacesAttract) {
  Scene scene = repelling_throat(0.99 * kHole);
  scene.surface = SurfaceChemistry{};
  scene.fidelity.hindrance = Hindrance::none;  // or the liquid keeps it off on its way
  ASSERT_TRUE(contacts_of(scene).rules.grains_attach);
  const Realisation r = drop_into(scene, 10e-6);
  ASSERT_EQ(r.retained.size(), 1u);
  EXPECT_NE(r.retained[0].mechanism, Mechanism::attachment_to_deposit);
  EXPECT_GT(r.alpha_deg, 0.0);
}

// Straight above the grain: the push is the weight and what the flow adds.
TEST(Repulsion, GivesWayToAPushBeyondItsLargest) {
  Scene scene = cases::one_grain_scene();
  scene.surface.ionic_strength = 10.0;
  scene.surface.zeta_grain = -27.9e-3;
  scene.fidelity.capture_gap.reset();
  const SurfaceModel contacts = contacts_of(scene);
  ASSERT_FALSE(contacts.rules.grains_attach);
  const double repulsion = contacts.rules.grain_repulsion;
  const double a = 0.5 * scene.colloids->diameter;
  const double mass =
      4.0 / 3.0 * kPi * a * a * a * (scene.colloids->density - scene.fluid.density);
  const double drag = stokes_drag(1e-3, a, 0.5e-3);
  std::printf("largest repulsion %.3e N, drag %.3e N, standoff %.3e m\n", repulsion, drag,
              contacts.rules.grain_gap);
  ASSERT_GT(repulsion, 20.0 * drag);
  for (double push : {0.9, 1.1}) {
    scene.gravity = {0.0, 0.0, -push * repulsion / mass};
    const Realisation r =
        cases::run_from(scene, {{released_at({30e-6, 30e-6, 55e-6})}, {}});
    ASSERT_EQ(r.retained.size(), push > 1.0 ? 1u : 0u) << push;
    if (push > 1.0) {
      EXPECT_EQ(r.retained.front().mechanism, Mechanism::attachment_to_grain);
      EXPECT_NEAR(r.retained.front().alpha_deg, 90.0, 0.1);
    }
  }
}

// A colloid behind a retained one, far from all else: the bond carries its drag.
class Bond : public ::testing::Test {
 protected:
  Bond() : scene_(cases::one_grain_scene()) {
    scene_.geometry.spheres[0] = {{45e-6, 45e-6, 15e-6}, 10e-6};
    deposit_ = {20e-6, 20e-6, 60e-6};
    gap_ = *scene_.fidelity.capture_gap;
  }
  Realisation run() const {
    const Vec3 n{0.6, 0.0, -0.8};
    return cases::run_from(
        scene_, {{released_at(deposit_ + n * (6e-6 + 0.9995 * gap_))}, {deposit_}});
  }
  Scene scene_;
  Vec3 deposit_;
  double gap_ = 0.0;
};

TEST_F(Bond, BreaksAboveItsPullOffAndNotBelow) {
  scene_.bonds = Bonds::permanent;
  const Realisation permanent = run();
  ASSERT_EQ(permanent.retained.size(), 1u);
  const RetainedColloid& rest = permanent.retained[0];
  const double load = rest.bond_load;
  const double drag = stokes_drag(1e-3, 3e-6, 0.5e-3);
  std::printf("load %.3e N, Stokes drag at the inlet's speed %.3e N\n", load, drag);
  EXPECT_GT(load, 0.2 * drag);
  EXPECT_LT(load, 2.1 * drag);  // the largest over the mean speed of a duct
  // Behind it, as seen along the flow.
  EXPECT_LT(rest.position.z, deposit_.z - 1.9 * 3e-6);

  const SurfaceModel contacts = contacts_of(scene_);
  const auto& analysis = contacts.colloid.analysis;
  const StationaryPoint& minimum = analysis.secondary_minimum
                                       ? *analysis.secondary_minimum
                                       : *analysis.primary_minimum;
  for (double strength : {0.95, 1.05}) {
    scene_.bonds = Bonds::breakable;
    scene_.surface.colloid_colloid_minimum =
        minimum.energy * strength * load / contacts.colloid.pull_off;
    ASSERT_NEAR(contacts_of(scene_).colloid.pull_off, strength * load, 1e-6 * load);
    const Realisation r = run();
    const bool holds = strength > 1.0;
    ASSERT_EQ(r.retained.size(), holds ? 1u : 0u);
    EXPECT_EQ(r.counts.traversed, holds ? 0 : 1);
    if (holds) {
      EXPECT_NEAR(r.retained[0].bond_load, load, 1e-3 * load);
      EXPECT_FALSE(r.retained[0].bond_overloaded);
    }
  }
  // Permanent, but weaker than its load: held and flagged.
  scene_.bonds = Bonds::permanent;
  scene_.surface.colloid_colloid_minimum =
      minimum.energy * 0.95 * load / contacts.colloid.pull_off;
  const Realisation flagged = run();
  ASSERT_EQ(flagged.retained.size(), 1u);
  EXPECT_TRUE(flagged.retained[0].bond_overloaded);
}

}  // namespace
}  // namespace colloid
