#include "physics/surface_pair.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "physics/pair_analysis.h"

namespace colloid {
namespace {

SurfacePair two_equal_spheres() {
  SurfacePair pair;
  pair.shape = PairShape::two_spheres;
  return pair;
}

TEST(SurfacePair, ExchangingTheTwoSpheresChangesNothing) {
  SurfacePair pair = two_equal_spheres();
  pair.radius = 1e-6;
  pair.other_radius = 30e-6;
  SurfacePair swapped = pair;
  std::swap(swapped.radius, swapped.other_radius);
  std::swap(swapped.zeta, swapped.other_zeta);
  for (double gap : {0.3e-9, 3e-9, 1e-6}) {
    const double energy = SurfaceForces(pair).energy(gap);
    EXPECT_NEAR(SurfaceForces(swapped).energy(gap) / energy, 1.0, 1e-13);
  }
}

// A sphere 1e6 times larger is a plate, to 1e-6 (Derjaguin's radius).
TEST(SurfacePair, VeryLargeSphereIsAPlate) {
  SurfacePair plate;
  SurfacePair spheres = two_equal_spheres();
  spheres.other_radius = 1e6 * spheres.radius;
  for (double gap : {0.3e-9, 3e-9, 1e-6}) {
    EXPECT_NEAR(SurfaceForces(spheres).energy(gap) / SurfaceForces(plate).energy(gap),
                1.0, 2e-6 * 10.0)  // the sum of terms of both signs
        << gap;
  }
}

TEST(SurfacePair, PotentialsOfOppositeSignAttractAndOneZeroAttractsWeakly) {
  SurfacePair pair;
  pair.hamaker = 0.0;
  pair.other_zeta = +15.7e-3;
  EXPECT_LT(SurfaceForces(pair).force(1e-9), 0.0);
  const double opposite = SurfaceForces(pair).energy(1e-9);
  pair.other_zeta = 0.0;  // constant potential: induced charge of the other sign
  EXPECT_LT(SurfaceForces(pair).energy(1e-9), 0.0);
  EXPECT_GT(SurfaceForces(pair).energy(1e-9), opposite);
}

TEST(SurfacePair, NothingActsWithoutHamakerConstantAndPotentials) {
  SurfacePair pair;
  pair.hamaker = 0.0;
  pair.zeta = 0.0;
  pair.other_zeta = 0.0;
  const SurfaceForces forces(pair);
  EXPECT_EQ(forces.energy(1e-9), 0.0);
  const PairAnalysis analysis = analyse_pair(forces);
  EXPECT_TRUE(analysis.stationary_points.empty());
  EXPECT_FALSE(analysis.primary_minimum.has_value());
  EXPECT_EQ(analysis.barrier_from_outside_kT, 0.0);
  EXPECT_EQ(capture_gap(forces, 1e-12), 0.0);
  EXPECT_EQ(interaction_range(forces, 1e-12), 0.0);
}

TEST(SurfacePair, WithoutBornTermThePrimaryMinimumIsTheClosestGap) {
  SurfacePair pair;
  pair.born_diameter = 0.0;
  const PairAnalysis analysis = analyse_pair(SurfaceForces(pair));
  ASSERT_TRUE(analysis.primary_minimum.has_value());
  EXPECT_EQ(analysis.primary_minimum->gap, pair.closest_gap);
}

TEST(SurfacePair, RepulsiveVanDerWaalsForceLeavesNoPrimaryMinimum) {
  SurfacePair pair;
  pair.hamaker = -1e-20;
  const SurfaceForces forces(pair);
  const PairAnalysis analysis = analyse_pair(forces);
  EXPECT_FALSE(analysis.primary_minimum.has_value());
  EXPECT_NEAR(analysis.barrier_from_outside_kT,
              forces.energy(pair.closest_gap) / forces.thermal_energy(), 1e-9);
  EXPECT_GT(analysis.largest_repulsion.force, 0.0);
  EXPECT_GT(interaction_range(forces, 1e-11), 1e-9);
}

// Pure water, equal potentials: a high barrier, an outer minimum far away.
TEST(SurfacePair, LowIonicStrengthBuildsABarrier) {
  SurfacePair pair;
  pair.electrolyte.ionic_strength = 0.1;
  const PairAnalysis analysis = analyse_pair(SurfaceForces(pair));
  ASSERT_TRUE(analysis.barrier && analysis.secondary_minimum && analysis.primary_minimum);
  EXPECT_GT(analysis.barrier_from_outside_kT, 1000.0);
  EXPECT_GT(analysis.secondary_minimum->gap, analysis.barrier->gap);
  EXPECT_GT(analysis.barrier->gap, analysis.primary_minimum->gap);
  EXPECT_GT(analysis.largest_repulsion.gap, analysis.barrier->gap);
  EXPECT_LT(analysis.largest_repulsion.gap, analysis.secondary_minimum->gap);
}

// Independent of the analysis: no sampled energy lies below the deepest minimum, none
// outside the primary minimum above the highest maximum.
TEST(SurfacePair, StationaryPointsBoundTheSampledEnergy) {
  for (double ionic_strength : {1.0, 30.0, 100.0, 300.0}) {
    SurfacePair pair = two_equal_spheres();
    pair.other_zeta = pair.zeta;
    pair.electrolyte.ionic_strength = ionic_strength;
    const SurfaceForces forces(pair);
    const PairAnalysis analysis = analyse_pair(forces);
    ASSERT_TRUE(analysis.primary_minimum && analysis.barrier);
    for (double gap = 0.16e-9; gap < 1e-6; gap *= 1.003) {
      const double energy = forces.energy(gap);
      EXPECT_GE(energy, analysis.primary_minimum->energy < 0.0
                            ? std::min(analysis.primary_minimum->energy,
                                       analysis.secondary_minimum->energy)
                            : analysis.secondary_minimum->energy);
      if (gap > analysis.primary_minimum->gap) {
        EXPECT_LE(energy, std::max(0.0, analysis.barrier->energy) * (1.0 + 1e-12));
      }
    }
  }
}

TEST(SurfacePair, RefusesWhatIsNotPhysical) {
  const auto refused = [](auto change) {
    SurfacePair pair;
    change(pair);
    EXPECT_THROW(SurfaceForces forces(pair), InputError);
  };
  refused([](SurfacePair& p) { p.radius = 0.0; });
  refused([](SurfacePair& p) { p.radius = std::nan(""); });
  refused([](SurfacePair& p) { p.hamaker = std::nan(""); });
  refused([](SurfacePair& p) { p.zeta = std::nan(""); });
  refused([](SurfacePair& p) { p.born_diameter = -1e-9; });
  refused([](SurfacePair& p) { p.closest_gap = 0.0; });
  refused([](SurfacePair& p) { p.wavelength = 0.0; });
  refused([](SurfacePair& p) { p.electrolyte.ionic_strength = 0.0; });
  refused([](SurfacePair& p) { p.electrolyte.temperature = -1.0; });
  refused([](SurfacePair& p) { p.electrolyte.relative_permittivity = 0.0; });
}

}  // namespace
}  // namespace colloid
