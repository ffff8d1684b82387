// The DLVO force as it acts on a colloid.
// Reference  the slope of the pair's energy, by differences of it at h (1 -+ 1e-4): their
//            error is about 1e-8 h^2 E'''/6 / E', a few 1e-8 for the van der Waals
//            powers.
// Tolerance  in the one sub-step of 1e-9 s from rest the gap changes by less than
//            F step^2/(2 m) = 5e-17 m, 1e-8 of it: 1e-6.
#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

double slope(const SurfaceForces& forces, double gap) {
  const double d = 1e-4 * gap;
  return -(forces.energy(gap + d) - forces.energy(gap - d)) / (2.0 * d);
}

DemOptions long_range() {
  DemOptions options = inert();
  options.long_range_forces = true;
  options.step = 1e-9;
  return options;
}

Vec3 force_on_first(Dem& dem) {
  return dem.advance(1e-9, {}).means.at(0).force;
}

TEST(DemSurfaceForces, OfAGrainIsTheSlopeOfItsEnergy) {
  for (const double gap : {2e-8, 5e-8, 1e-7}) {
    const DemOptions options = long_range();
    Dem dem(options, {{kMiddle, 4e-5}});
    dem.add({0, kMiddle + Vec3{4e-5 + kRadius + gap, 0.0, 0.0}, {}, {}});
    const double expected = slope(options.surfaces.grain.forces, gap);
    const Vec3 force = force_on_first(dem);
    EXPECT_LT(expected, 0.0);
    EXPECT_NEAR(force.x / expected, 1.0, 1e-6) << gap;
    EXPECT_EQ(force.y, 0.0);
  }
}

TEST(DemSurfaceForces, OfTwoColloidsIsTheSlopeOfTheirEnergyOnBoth) {
  for (const double gap : {1e-8, 5e-8}) {
    const DemOptions options = long_range();
    Dem dem(options, {});
    dem.add({0, kMiddle, {}, {}});
    dem.add({1, kMiddle + Vec3{0.0, 2.0 * kRadius + gap, 0.0}, {}, {}});
    const std::vector<DemMean> means = dem.advance(1e-9, {}).means;
    const double expected = slope(options.surfaces.colloid.forces, gap);
    EXPECT_NEAR(-means.at(0).force.y / expected, 1.0, 1e-6) << gap;
    EXPECT_EQ(means.at(0).force.y, -means.at(1).force.y);
  }
}

TEST(DemSurfaceForces, OfAWallAttractsOnlyIfItIsAdhesive) {
  DemOptions options = long_range();
  const auto force = [&options](double gap = 2e-8) {
    Dem dem(options, {});
    dem.add({0, {2e-4 - kRadius - gap, 1e-4, 1e-4}, {}, {}});
    return force_on_first(dem).x;
  };
  EXPECT_EQ(force(), 0.0);
  options.surfaces.rules.walls_attach = true;
  EXPECT_NEAR(force() / -slope(options.surfaces.wall.forces, 2e-8), 1.0, 1e-6);
  const double range =
      interaction_range(options.surfaces.wall.forces, options.least_surface_force);
  EXPECT_GT(force(0.999 * range), 0.0);
  EXPECT_EQ(force(1.001 * range), 0.0);
}

TEST(DemSurfaceForces, AreOffBeyondTheirRangeAndWithoutTheOption) {
  DemOptions options = long_range();
  const auto force = [&options](double gap) {
    Dem dem(options, {{kMiddle, 4e-5}});
    dem.add({0, kMiddle + Vec3{4e-5 + kRadius + gap, 0.0, 0.0}, {}, {}});
    return force_on_first(dem).x;
  };
  const double range =
      interaction_range(options.surfaces.grain.forces, options.least_surface_force);
  EXPECT_LT(force(0.999 * range), 0.0);
  EXPECT_EQ(force(1.001 * range), 0.0);
  options.long_range_forces = false;
  EXPECT_EQ(force(2e-8), 0.0);
}

}  // namespace
}  // namespace colloid::dem_test
