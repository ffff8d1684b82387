// The longest sub-step.
// Reference  Rayleigh time of the colloid: 1.41e-7 s (its formula, evaluated by hand).
//            Beyond leapfrog's limit a bonded cluster gains energy in every sub-step.
// Tolerance  the reference has three digits.  At 0.98 of the limit the energy must not
// grow
//            over 2000 sub-steps; no damping but that of the bonds.
#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

TEST(DemLimits, AreTheRayleighTimeInTheReferenceScene) {
  const DemStepLimits limits = step_limits(bonding());
  EXPECT_NEAR(limits.rayleigh, 1.41e-7, 0.005e-7);
  EXPECT_EQ(limits.largest(), limits.rayleigh);
  EXPECT_EQ(step_limits(inert()).bonds, HUGE_VAL);
}

TEST(DemLimits, ScaleWithStiffnessAndMass) {
  DemOptions options = bonding();
  options.long_range_forces = true;
  const DemStepLimits before = step_limits(options);
  options.density *= 4.0;
  const DemStepLimits heavy = step_limits(options);
  EXPECT_NEAR(heavy.rayleigh / before.rayleigh, 2.0, 1e-12);
  EXPECT_NEAR(heavy.bonds / before.bonds, 2.0, 1e-12);
  EXPECT_NEAR(heavy.surface_forces / before.surface_forces, 2.0, 1e-12);
  // van der Waals: 24 a A / (72 h^3) at the grain's gap of contact, to a few percent.
  const double gap = options.surfaces.grain.gap;
  const double steep = 1e-20 * kRadius / (3.0 * gap * gap * gap);
  EXPECT_LT(before.surface_forces, 1.05 * 2.0 / std::sqrt(24.0 * steep / kMass));
}

constexpr double kSoft = 1e5;  // [Pa] where bonds limit more than the Rayleigh time

/// A colloid and the twelve that touch it in a close packing, all bonded, shaken.
double energy_after(double step, int rounds) {
  DemOptions options = bonding();
  options.colloid.young_modulus = kSoft;
  options.step = step;
  Dem dem(options, {});
  const double s = (2.0 * kRadius + 1e-9) / std::sqrt(2.0);
  int id = 0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      for (int k = -1; k <= 1; ++k) {
        const int steps = i * i + j * j + k * k;
        if (steps == 0 || steps == 2) {
          const double v = 1e-4 * (id % 2 == 0 ? 1.0 : -1.0);
          dem.add({id,
                   kMiddle + s * Vec3{double(i), double(j), double(k)},
                   {v, -v, id % 3 == 0 ? v : 0.0},
                   {}});
          ++id;
        }
      }
    }
  }
  for (int i = 0; i < rounds; ++i) {
    dem.advance(100.0 * step, {});
  }
  EXPECT_EQ(dem.bonds().size(), 36U);
  double energy = 0.0;
  for (const DemState& state : dem.states()) {
    energy += 0.5 * kMass * dot(state.velocity, state.velocity);
  }
  return energy;
}

TEST(DemLimits, KeepAClusterOfBondsStable) {
  DemOptions options = bonding();
  options.colloid.young_modulus = kSoft;
  ASSERT_EQ(step_limits(options).largest(), step_limits(options).bonds);
  const double step = 0.98 * step_limits(options).largest();
  const double early = energy_after(step, 1);
  const double late = energy_after(step, 20);
  EXPECT_GT(early, 0.0);
  EXPECT_LE(late, early * (1.0 + 1e-9));
}

}  // namespace
}  // namespace colloid::dem_test
