// Every corner of the parameters that a scene may hold gives finite numbers, and an
// analysis that is consistent with itself.  The table on standard output is the one in
// results/evidence/extremes.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "physics/pair_analysis.h"
#include "physics/regime_numbers.h"

namespace colloid {
namespace {

struct Counts {
  int pairs = 0;
  int with_barrier = 0;
  int without_primary_minimum = 0;
};

void expect_finite_forces(const SurfaceForces& forces) {
  for (double gap : {1e-15, 1e-12, 0.158e-9, 1e-9, 1e-8, 1e-6, 1e-3, 1.0}) {
    ASSERT_TRUE(std::isfinite(forces.energy(gap))) << gap;
    ASSERT_TRUE(std::isfinite(forces.force(gap))) << gap;
  }
}

void expect_consistent(const SurfaceForces& forces, const PairAnalysis& analysis) {
  ASSERT_TRUE(std::isfinite(analysis.barrier_from_outside_kT));
  ASSERT_TRUE(std::isfinite(analysis.barrier_from_secondary_kT));
  ASSERT_GE(analysis.barrier_from_secondary_kT, analysis.barrier_from_outside_kT);
  ASSERT_TRUE(std::isfinite(analysis.primary_pull_off.force));
  ASSERT_TRUE(std::isfinite(analysis.largest_repulsion.force));
  const auto& points = analysis.stationary_points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(std::isfinite(points[i].energy_kT));
    if (i > 0) {  // minima and maxima alternate, from far to near
      ASSERT_LT(points[i].gap, points[i - 1].gap);
      ASSERT_NE(points[i].kind, points[i - 1].kind);
    }
  }
  const double drag = stokes_drag(1e-3, forces.pair().radius, 1e-6);
  const double range = interaction_range(forces, drag);
  ASSERT_TRUE(std::isfinite(range));
  ASSERT_GE(range, capture_gap(forces, drag) * (1.0 - 1e-9));
}

void check(const SurfacePair& pair, Counts& counts) {
  SCOPED_TRACE(::testing::Message()
               << "I " << pair.electrolyte.ionic_strength << " A " << pair.hamaker
               << " zeta " << pair.zeta << " " << pair.other_zeta << " a " << pair.radius
               << " T " << pair.electrolyte.temperature);
  const SurfaceForces forces(pair);
  const PairAnalysis analysis = analyse_pair(forces);
  expect_finite_forces(forces);
  expect_consistent(forces, analysis);
  ++counts.pairs;
  counts.with_barrier += analysis.barrier_from_secondary_kT > 0.0 ? 1 : 0;
  counts.without_primary_minimum += analysis.primary_minimum ? 0 : 1;
}

void check_forms(SurfacePair pair, Counts& counts) {
  for (PairShape shape : {PairShape::sphere_plate, PairShape::two_spheres}) {
    for (DoubleLayerForm layer :
         {DoubleLayerForm::constant_potential, DoubleLayerForm::superposition}) {
      pair.shape = shape;
      pair.double_layer = layer;
      pair.van_der_waals = layer == DoubleLayerForm::superposition
                               ? VanDerWaalsForm::retarded
                               : VanDerWaalsForm::unretarded;
      check(pair, counts);
      if (::testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

TEST(SurfaceExtremes, EveryCornerIsFiniteAndConsistent) {
  std::printf(
      "ionic strength [mM], radius [m]: pairs, with a barrier, unable to attach\n");
  for (double ionic_strength : {0.1, 10.0, 300.0, 5000.0}) {
    for (double radius : {10e-9, 6.65e-6, 1e-3}) {
      Counts counts;
      for (double hamaker : {-1e-19, 0.0, 1e-24, 1e-20, 1e-18}) {
        for (double zeta : {-200e-3, 0.0, 28e-3}) {
          for (double temperature : {273.0, 373.0}) {
            SurfacePair pair;
            pair.radius = radius;
            pair.other_radius = radius;
            pair.hamaker = hamaker;
            pair.zeta = zeta;
            pair.electrolyte.ionic_strength = ionic_strength;
            pair.electrolyte.temperature = temperature;
            for (double other : {-15.7e-3, 0.0, 100e-3, zeta}) {
              pair.other_zeta = other;
              check_forms(pair, counts);
              if (HasFatalFailure()) {
                return;
              }
            }
          }
        }
      }
      std::printf("%6g %9.3g: %4d %4d %4d\n", ionic_strength, radius, counts.pairs,
                  counts.with_barrier, counts.without_primary_minimum);
    }
  }
}

TEST(SurfaceExtremes, ReferencePairAcrossIonicStrength) {
  std::printf(
      "I [mM]  Debye [nm]  barrier [kT]  secondary [kT at nm]  primary [kT at nm]  "
      "pull-off [nN]  capture gap [nm]\n");
  double previous_barrier = std::numeric_limits<double>::infinity();
  for (double ionic_strength : {0.1, 1.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 5000.0}) {
    SurfacePair pair;
    pair.electrolyte.ionic_strength = ionic_strength;
    const SurfaceForces forces(pair);
    const PairAnalysis a = analyse_pair(forces);
    ASSERT_TRUE(a.primary_minimum.has_value());
    // More salt screens more: the barrier falls.
    EXPECT_LE(a.barrier_from_outside_kT, previous_barrier);
    previous_barrier = a.barrier_from_outside_kT;
    const double gap = capture_gap(forces, stokes_drag(1e-3, pair.radius, 0.5e-3));
    std::printf("%6g  %8.4f  %12.1f  %10.2f at %7.2f  %10.1f at %6.4f  %8.2f  %8.2f\n",
                ionic_strength, 1e9 * forces.debye_length(), a.barrier_from_secondary_kT,
                a.secondary_minimum ? a.secondary_minimum->energy_kT : 0.0,
                a.secondary_minimum ? 1e9 * a.secondary_minimum->gap : 0.0,
                a.primary_minimum->energy_kT, 1e9 * a.primary_minimum->gap,
                1e9 * a.primary_pull_off.force, 1e9 * gap);
  }
}

}  // namespace
}  // namespace colloid
