// The numbers are those of the reference scene as its authors' parameters give them; each
// tolerance is half a unit of the last digit that is quoted.
#include "physics/regime_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/electrolyte.h"

namespace colloid {
namespace {

using ::testing::HasSubstr;

constexpr double kRadius = 6.65e-6;
constexpr double kSpeed = 0.5e-3;
constexpr double kViscosity = 1e-3;

TEST(RegimeNumbers, AreThoseOfTheReferenceScene) {
  EXPECT_NEAR(particle_reynolds(1000.0, kSpeed, 2.0 * kRadius, kViscosity), 0.00665,
              5e-6);
  const double throat = throat_reynolds(1000.0, 4.66 * kSpeed, 40.013e-6, kViscosity);
  EXPECT_NEAR(throat, 0.0932, 5e-5);
  EXPECT_NEAR(stokes_number(1050.0, kRadius, kSpeed, kViscosity), 8e-4, 5e-5);
  EXPECT_NEAR(relaxation_time(1050.0, kRadius, kViscosity), 10.3e-6, 0.05e-6);
  EXPECT_NEAR(relaxation_time(1050.0 + 500.0, kRadius, kViscosity), 15.2e-6, 0.05e-6);
  EXPECT_NEAR(viscous_time(kRadius, 1000.0, kViscosity), 44e-6, 0.5e-6);
  const double d = diffusivity(298.0, kViscosity, kRadius);
  EXPECT_NEAR(d, 3.28e-14, 0.005e-14);
  EXPECT_NEAR(peclet_number(kSpeed, kRadius, d), 1e5, 5e3);
  const double settling = settling_speed(1050.0, 1000.0, 9.81, kRadius, kViscosity);
  EXPECT_NEAR(settling, 4.8e-6, 0.05e-6);
  EXPECT_NEAR(gravity_number(settling, kSpeed), 0.0096, 5e-5);
  EXPECT_NEAR(stokes_drag(kViscosity, kRadius, kSpeed), 6.267e-11, 0.0005e-11);
}

// Quoted at 298.15 K: 1 part in 4000 more than at 298 K, plus the last digit.
TEST(RegimeNumbers, DebyeLengthFollowsTheIonicStrength) {
  EXPECT_NEAR(debye_length({300.0, 78.55, 298.15}), 0.5556e-9, 0.00005e-9);
  EXPECT_NEAR(debye_length({10.0, 78.55, 298.15}), 3.043e-9, 0.0005e-9);
  EXPECT_NEAR(debye_length({1.0, 78.55, 298.15}), 9.623e-9, 0.0005e-9);
}

TEST(RegimeNumbers, RisingColloidHasAPositiveGravityNumber) {
  const double speed = settling_speed(900.0, 1000.0, 9.81, kRadius, kViscosity);
  EXPECT_LT(speed, 0.0);
  EXPECT_GT(gravity_number(speed, kSpeed), 0.0);
}

RegimeNumbers reference_scene() {
  return {0.093, 8e-3, 1.01e5, 0.0096, 13.3e-9 / kRadius, 0.0, false};
}

TEST(DecideModels, ReferenceSceneNeedsGravityAndLubricationOnly) {
  const ModelDecisions d = decide_models(reference_scene());
  EXPECT_FALSE(d.brownian.needed);
  EXPECT_TRUE(d.gravity.needed);
  EXPECT_FALSE(d.inertia.needed);
  EXPECT_TRUE(d.lubrication.needed);
  EXPECT_FALSE(d.long_range_dlvo.needed);
  EXPECT_THAT(d.brownian.reason, HasSubstr("Pe(a) = 1.01e+05 > 100"));
  EXPECT_THAT(d.gravity.reason, HasSubstr("settling/U = 0.0096 > 0.001"));
  EXPECT_THAT(d.inertia.reason, HasSubstr("Re_throat = 0.093 < 1"));
  EXPECT_THAT(d.inertia.reason, HasSubstr("Stokes = 0.008 < 0.1"));
  EXPECT_THAT(d.long_range_dlvo.reason, HasSubstr("DLVO range/a = 0.002 < 0.01"));
}

TEST(DecideModels, EachLimitIsSharp) {
  RegimeNumbers n = reference_scene();
  n.peclet = 100.0;
  EXPECT_FALSE(decide_models(n).brownian.needed);
  n.peclet = 99.9;
  EXPECT_TRUE(decide_models(n).brownian.needed);

  n = reference_scene();
  n.reynolds_throat = 1.0;
  n.stokes = 0.1;
  EXPECT_FALSE(decide_models(n).inertia.needed);
  n.reynolds_throat = 1.01;
  EXPECT_TRUE(decide_models(n).inertia.needed);
  EXPECT_EQ(decide_models(n).inertia.reason, "Re_throat = 1.01 > 1");
  n.reynolds_throat = 1.0;
  n.stokes = 0.11;
  EXPECT_TRUE(decide_models(n).inertia.needed);
  EXPECT_EQ(decide_models(n).inertia.reason, "Stokes = 0.11 > 0.1");

  n = reference_scene();
  n.gravity = 1e-3;
  EXPECT_FALSE(decide_models(n).gravity.needed);

  n.dlvo_range_over_radius = 0.01;
  EXPECT_FALSE(decide_models(n).long_range_dlvo.needed);
  n.dlvo_range_over_radius = 0.011;
  EXPECT_TRUE(decide_models(n).long_range_dlvo.needed);

  n.flow_resolves_gaps = true;
  EXPECT_FALSE(decide_models(n).lubrication.needed);
}

TEST(DecideModels, BarrierThatThermalMotionCanCrossMakesBrownianMotionNecessary) {
  RegimeNumbers n = reference_scene();
  for (double barrier : {5.0, 12.0, 30.0}) {
    n.grain_barrier_kT = barrier;
    EXPECT_TRUE(decide_models(n).brownian.needed) << barrier;
    EXPECT_THAT(decide_models(n).brownian.reason, HasSubstr("within 5-30 kT"));
  }
  for (double barrier : {0.5, 4.9, 30.1, 5000.0}) {
    n.grain_barrier_kT = barrier;
    EXPECT_FALSE(decide_models(n).brownian.needed) << barrier;
    EXPECT_TRUE(decide_models(n).long_range_dlvo.needed) << barrier;
  }
}

}  // namespace
}  // namespace colloid
