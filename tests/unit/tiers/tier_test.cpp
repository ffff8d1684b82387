#include "tiers/tier.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "core/constants.h"
#include "core/error.h"
#include "scene/read_scene.h"
#include "tiers/transient_cost.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::optional<Realisation> no_run(const Scene& /*scene*/, const RunOptions& /*options*/) {
  return std::nullopt;
}

const TierTable kSolve{
    kSolveProgram, {{TierChoice::one_way, no_run}, {TierChoice::quasi_steady, no_run}}};
const TierTable kTransient{kTransientProgram, {{TierChoice::transient, no_run}}};

/// 40 x 40 x 60 um, 4 cells per colloid of 10 um; nothing is injected.
Scene duct(double inlet_velocity, TierChoice tier) {
  Scene scene = parse_scene(R"({"geometry": {"box": ["40 um", "40 um", "60 um"],
      "faces": {"x-": "wall", "x+": "wall", "y-": "wall", "y+": "wall",
                "z-": "outlet", "z+": "inlet"}},
      "drive": {"inlet_velocity": "1 mm/s"},
      "colloids": {"diameter": "10 um", "volume_fraction": 0}, "duration": "2 s",
      "fidelity": {"cells_per_colloid": 4}})",
                            "duct.json")
                    .scene;
  scene.drive.inlet_velocity = inlet_velocity;
  scene.fidelity.tier = tier;
  return scene;
}

std::string refusal(const Scene& scene, const TierTable& table) {
  try {
    choose_tier(scene, table, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

constexpr double kSlow = 1e-3;
constexpr double kFast = 0.1;  // Re_throat = 0.1 x 40e-6 / 1e-6 = 4

TEST(ChooseTier, TakesWhatIsAskedForFromItsOwnTable) {
  for (const TierChoice tier : {TierChoice::one_way, TierChoice::quasi_steady}) {
    const TierDecision decision = choose_tier(duct(kSlow, tier), kSolve, 1);
    EXPECT_EQ(decision.tier.choice, tier);
    EXPECT_EQ(decision.reason, "asked for");
    EXPECT_EQ(decision.warning, "");
    EXPECT_THAT(refusal(duct(kSlow, tier), kTransient),
                HasSubstr("run it with poreclog-solve: poreclog-solve-transient has"));
  }
  EXPECT_THAT(refusal(duct(kFast, TierChoice::transient), kSolve),
              HasSubstr("/fidelity/tier: is transient; run it with "
                        "poreclog-solve-transient: poreclog-solve has"));
}

TEST(ChooseTier, TakesTheTransientTierByItselfWhereInertiaCounts) {
  const Scene fast = duct(kFast, TierChoice::automatic);
  const TierDecision decision = choose_tier(fast, kTransient, 1);
  EXPECT_EQ(decision.tier.choice, TierChoice::transient);
  EXPECT_THAT(decision.reason, HasSubstr("auto: inertia counts: Re_throat = 4 > 1"));
  EXPECT_EQ(decision.warning, "");
  EXPECT_THAT(refusal(fast, kSolve),
              HasSubstr("is auto, which means transient here (inertia counts: "
                        "Re_throat = 4 > 1"));
  EXPECT_THAT(refusal(fast, kSolve), HasSubstr("run it with poreclog-solve-transient"));
}

// tau_p = 2 x 1e5 kg/m^3 (5 um)^2/(9 mu) = 5.6e-4 s: St = tau_p U/a > 0.1 at 1 mm/s.
TEST(ChooseTier, LooksAtTheColloidsInertiaToo) {
  Scene heavy = duct(kSlow, TierChoice::automatic);
  heavy.colloids->density = 1e5;
  heavy.gravity = {};
  const TierDecision decision = choose_tier(heavy, kTransient, 1);
  EXPECT_THAT(decision.reason, HasSubstr("auto: inertia counts: Stokes = "));
}

TEST(ChooseTier, TakesTheCheapestTierByItselfWhereInertiaDoesNot) {
  Scene slow = duct(kSlow, TierChoice::automatic);
  EXPECT_EQ(choose_tier(slow, kSolve, 1).tier.choice, TierChoice::one_way);
  EXPECT_THAT(refusal(slow, kTransient), HasSubstr("which means one_way here"));
  slow.geometry.bodies.push_back({{{20e-6, 20e-6, 30e-6}, 5e-6}, {}, {}, {}});
  EXPECT_EQ(choose_tier(slow, kSolve, 1).tier.choice, TierChoice::one_way);
  slow.geometry.bodies[0].velocity = Vec3{0.0, 0.0, 1e-4};
  const TierDecision driven = choose_tier(slow, kSolve, 1);
  EXPECT_EQ(driven.tier.choice, TierChoice::quasi_steady);
  EXPECT_THAT(driven.reason, HasSubstr("at a velocity"));
}

TEST(ChooseTier, GrantsTheTransientTierAndSaysWhatItCosts) {
  const TierDecision slow =
      choose_tier(duct(kSlow, TierChoice::transient), kTransient, 1);
  EXPECT_THAT(slow.reason, HasSubstr("asked for; Re_throat = 0.04 < 1"));
  EXPECT_THAT(slow.warning, HasSubstr("one_way is the cheapest that is valid; about "));
  const TierDecision fast =
      choose_tier(duct(kFast, TierChoice::transient), kTransient, 1);
  EXPECT_THAT(fast.reason, HasSubstr("asked for; Re_throat = 4 > 1"));
  EXPECT_EQ(fast.warning, "");
}

Regime at_speed(double largest_speed) {
  Regime regime;
  regime.scales.largest_speed = largest_speed;
  regime.colloids = ColloidRegime{};
  return regime;
}

// Without grains and colloids: 16 x 16 x 24 cells of 2.5 um; 2 s at 3 mm/s are 6 mm, of
// which a step covers 0.3 of half a cell.
TEST(TransientCost, IsCellsTimesSteps) {
  const TransientCost cost =
      predict_transient_cost(duct(kSlow, TierChoice::transient), at_speed(3e-3));
  EXPECT_NEAR(cost.cells, 16.0 * 16.0 * 24.0, 1e-6);
  EXPECT_NEAR(cost.steps, 6e-3 / (0.3 * 1.25e-6), 1e-6);
  EXPECT_NEAR(cost.seconds, 1.2e-6 * cost.cells * cost.steps, 1e-6);
}

// A ball of 4 cells and one more all around: pi/6 6^3 cells, of which each becomes 8; as
// many steps of its motion as there are in 2 s.
TEST(TransientCost, GrowsWithColloids) {
  Scene scene = duct(kSlow, TierChoice::transient);
  const double empty = predict_transient_cost(scene, at_speed(3e-3)).cells;
  scene.geometry.bodies.push_back({{{20e-6, 20e-6, 30e-6}, 5e-6}, {}, {}, {}});
  const TransientCost cost = predict_transient_cost(scene, at_speed(3e-3));
  EXPECT_NEAR(cost.cells - empty, 7.0 * kPi / 6.0 * 216.0, 1e-6);
  EXPECT_NEAR(cost.seconds - 1.2e-6 * cost.cells * cost.steps, 4.8e-8 * 2.0 / 50e-9,
              1e-6);
  scene.fidelity.refinement = 0;
  const TransientCost coarse = predict_transient_cost(scene, at_speed(3e-3));
  EXPECT_NEAR(coarse.cells, empty, 1e-6);
  EXPECT_NEAR(coarse.steps, 0.5 * cost.steps, 1e-6);
}

// One cell all around a grain of 10 um: 4 pi/3 ((5 + 2.5)^3 - 5^3) um^3, each 8 then; the
// count of points is exact within 1 % of the box, times 7.
TEST(TransientCost, GrowsWithRefinementAtGrains) {
  Scene scene = duct(kSlow, TierChoice::transient);
  scene.geometry.spheres.push_back({{20e-6, 20e-6, 30e-6}, 5e-6});
  const double without = predict_transient_cost(scene, at_speed(3e-3)).cells;
  scene.fidelity.wall_refinement = 1;
  const double with = predict_transient_cost(scene, at_speed(3e-3)).cells;
  const double shell = 4.0 * kPi / 3.0 * (421.875 - 125.0) / 15.625;
  EXPECT_NEAR(with - without, 7.0 * shell, 7.0 * 0.01 * 16 * 16 * 24);
}

}  // namespace
}  // namespace colloid
