// Problem    mean time of a diffusing colloid to get over an energy barrier.
// Reference  (a) closed forms: flat and linear potentials, a diffusivity that grows with
// the
//                gap, Kramers' rate (1940) for a cubic potential with its first
//                correction;
//            (b) the double integral of a pair's curve by the trapezoidal rule;
//            (c) a simulated Langevin ensemble in the curve of a pair.
// Tolerance  derived at each test.
#include "physics/barrier_escape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/constants.h"
#include "core/error.h"
#include "physics/passage_time.h"
#include "physics/wall_resistance.h"

namespace colloid {
namespace {

constexpr double kRule = 1e-6;  // of the cells, see passage_time.cpp

// tau = (s - a) (b - (s + a)/2)/D from s to the absorbing a, reflected at b.
TEST(PassageTime, IsTheDiffusionTimeInAFlatPotential) {
  for (double b : {2.0, 11.0}) {
    for (double s : {1.5, 2.0}) {
      const Passage passage{[](double) { return 3.0; }, [](double) { return 0.7; }, 1.0,
                            s, b};
      EXPECT_NEAR(mean_passage_time(passage) / ((s - 1.0) * (b - (s + 1.0) / 2.0) / 0.7),
                  1.0, kRule);
    }
  }
}

// W = f h: D tau = L/f - (1 - exp(-f L))/f^2 when it helps, and with f -> -f when it
// hinders; start at the reflecting point, L away.
TEST(PassageTime, IsTheClosedFormInALinearPotential) {
  for (double f : {-30.0, -3.0, 0.1, 3.0, 30.0, 3000.0}) {
    const Passage passage{[f](double h) { return f * h; }, [](double) { return 2.0; },
                          0.5, 2.5, 2.5};
    const double expected = (2.0 / f + std::expm1(-f * 2.0) / (f * f)) / 2.0;
    EXPECT_NEAR(mean_passage_time(passage) / expected, 1.0, kRule) << f;
  }
}

// Flat, D = k h: tau = (b ln(b/a) - (b - a))/k.
TEST(PassageTime, WeighsTheDiffusivityWhereTheColloidIs) {
  const Passage passage{[](double) { return 0.0; }, [](double h) { return 4.0 * h; },
                        1e-3, 1.0, 1.0};
  EXPECT_NEAR(mean_passage_time(passage) / ((std::log(1e3) - 0.999) / 4.0), 1.0, kRule);
}

/// W = e (3 x^2 - 2 x^3), x = (h_well - h)/L: a well at x = 0, a barrier of height e
/// at 1.
Passage cubic(double e) {
  constexpr double kWell = 3e-9;
  constexpr double kLength = 1e-9;
  return {[e](double h) {
            const double x = (kWell - h) / kLength;
            return e * x * x * (3.0 - 2.0 * x);
          },
          [](double) { return 1e-15; }, kWell - 1.49 * kLength, kWell,
          kWell + 1.5 * kLength};
}

// Kramers: tau_K = 2 pi L^2 exp(e)/(6 e D).  Laplace's method gives at the well and at
// the barrier each a first correction 5 W'''^2/(24 W''^3) = 5/(36 e), so tau/tau_K = 1 +
// 5/(18 e)
// + O(1/e^2); the next coefficient is of order one (385/(2 36^2) = 0.15 at each end).
TEST(PassageTime, IsKramersWithItsFirstCorrectionOverAHighBarrier) {
  for (double e : {15.0, 30.0, 100.0, 500.0}) {
    const double log_kramers = std::log(2.0 * kPi * 1e-18 / (6.0 * e * 1e-15)) + e;
    const double excess = std::expm1(std::log(mean_passage_time(cubic(e))) - log_kramers);
    EXPECT_NEAR(excess * e, 5.0 / 18.0, 1.0 / e + kRule * e) << e;
    std::printf("barrier %g kT: (tau/tau_Kramers - 1) e = %.4f (5/18 = 0.2778)\n", e,
                excess * e);
  }
}

TEST(PassageTime, NeitherOverflowsNorVanishes) {
  EXPECT_TRUE(std::isfinite(mean_passage_time(cubic(680.0))));
  EXPECT_TRUE(std::isinf(mean_passage_time(cubic(720.0))));
  const double none = mean_passage_time(cubic(0.0));
  EXPECT_NEAR(none / (1.49 * (2.99 - 1.49 / 2.0) * 1e-18 / 1e-15), 1.0, kRule);
}

/// A colloid of 50 nm in 10 mM at a plate: 2.6 kT to escape from a well half a kT deep.
SurfacePair small_colloid() {
  SurfacePair pair;
  pair.radius = 50e-9;
  pair.zeta = pair.other_zeta = -15e-3;
  pair.electrolyte.ionic_strength = 10.0;
  return pair;
}

/// The curve W/kT and the diffusivity of small_colloid against the gap, uniform.
struct Table {
  Table(const SurfaceForces& forces, double viscosity, double force) {
    const double a = forces.pair().radius;
    const double bulk = forces.thermal_energy() / (6.0 * kPi * viscosity * a);
    const auto size = static_cast<std::size_t>(a / kStep);
    for (std::size_t i = 1; i < size; ++i) {
      const double h = static_cast<double>(i) * kStep;
      energy.push_back((forces.energy(h) + force * h) / forces.thermal_energy());
      diffusivity.push_back(bulk / wall_resistance(h / a).f_n);
    }
  }
  static double gap(std::size_t i) { return static_cast<double>(i + 1) * kStep; }
  static std::size_t index(double h) { return static_cast<std::size_t>(h / kStep) - 1; }

  static constexpr double kStep = 5e-12;
  std::vector<double> energy, diffusivity;
};

// Trapezoidal rule at steps of 5 pm of a curve of length scale 3 nm (the Debye length)
// down to where it has fallen 10 kT inside the barrier: (5e-12/3e-9)^2 times 10, and
// exp(-10) times the well's width over the barrier's, about 3, of colloids that return
// from there: 2e-4.
TEST(BarrierEscape, IsTheDoubleIntegralOfThePairsCurve) {
  const SurfaceForces forces(small_colloid());
  const PairAnalysis analysis = analyse_pair(forces);
  for (double force : {-5e-14, 0.0, 1e-13, 1e-12}) {
    const BarrierEscape found = barrier_escape(forces, analysis, {1e-3, force});
    const Table table(forces, 1e-3, force);
    const auto& w = table.energy;
    const std::size_t start = Table::index(found.start_gap);
    double top = -1e300;
    std::size_t at_top = start;
    for (std::size_t i = start; i > 0; --i) {
      if (w[i] < top - 10.0) {
        break;
      }
      if (w[i] > top) {
        top = w[i];
        at_top = i;
      }
    }
    EXPECT_NEAR(found.barrier_kT, top - w[start], 1e-3);
    // Reflected at the curve's maximum outside the well, or at one radius.
    std::size_t last = w.size() - 1;
    for (std::size_t i = start + 200; i + 1 < last; ++i) {
      if (w[i] > w[i - 1] && w[i] > w[i + 1]) {
        last = i;
        break;
      }
    }
    double inner = 0.0;
    double time = 0.0;
    double before = 0.0;
    for (std::size_t i = last; i-- > 0;) {
      inner += 0.5 * Table::kStep * (std::exp(-w[i]) + std::exp(-w[i + 1]));
      const double rate = inner * std::exp(w[i]) / table.diffusivity[i];
      time += i < start ? 0.5 * Table::kStep * (rate + before) : 0.0;
      before = rate;
      if (i < at_top && w[i] < top - 10.0) {
        break;
      }
    }
    // The start is known to one step, over which dt/dh is J/D there: 1e-3 of the time.
    EXPECT_NEAR(found.time / time, 1.0, 2e-4 + 2e-3) << force;
    std::printf("force %g N: barrier %.3f kT, tau %.6g s, trapezoidal %.6g s\n", force,
                found.barrier_kT, found.time, time);
  }
}

// Euler-Maruyama with the drift -D W' + D' that a varying D asks for (Ermak & McCammon
// 1978). A relaxation rate k = D W'' is wrong by k dt/2, which acts as a temperature: the
// time by (1 + barrier) k dt/2; dt makes that 2 %.  Absorbed 8 kT inside the barrier:
// exp(-8) return. Tolerance 4 standard errors (1 false alarm in 16,000) + 2.1 %.
TEST(BarrierEscape, IsTheMeanOfALangevinEnsemble) {
  const SurfaceForces forces(small_colloid());
  const PairAnalysis analysis = analyse_pair(forces);
  struct Case {
    double force;
    int colloids;
  };
  for (const Case& c : {Case{1e-12, 2500}, Case{2e-13, 300}}) {
    const BarrierEscape found = barrier_escape(forces, analysis, {1e-3, c.force});
    ASSERT_TRUE(std::isfinite(found.time));
    ASSERT_GT(found.barrier_kT, 0.1);
    const Table table(forces, 1e-3, c.force);
    const auto& w = table.energy;
    const auto& d = table.diffusivity;
    const std::size_t start = Table::index(found.start_gap);
    std::size_t end = start;
    while (w[end] > w[start] + found.barrier_kT - 8.0) {
      --end;
    }
    std::vector<double> drift(w.size(), 0.0);
    double fastest = 0.0;
    for (std::size_t i = 1; i + 1 < w.size(); ++i) {
      drift[i] =
          (-d[i] * (w[i + 1] - w[i - 1]) + d[i + 1] - d[i - 1]) / (2.0 * Table::kStep);
      // The well and the barrier decide, not the slope behind it.
      if (i > end && w[i] > w[start] && i < start) {
        fastest = std::max(fastest, d[i] * std::abs(w[i + 1] - 2.0 * w[i] + w[i - 1]) /
                                        (Table::kStep * Table::kStep));
      }
    }
    const double dt = 0.02 * 2.0 / ((1.0 + found.barrier_kT) * fastest);
    std::mt19937_64 random(20240229);
    std::normal_distribution<double> normal;
    double sum = 0.0;
    double squares = 0.0;
    const double absorbing = Table::gap(end);
    const double wall = Table::gap(w.size() - 2);
    for (int k = 0; k < c.colloids; ++k) {
      double h = found.start_gap;
      long steps = 0;
      for (; h > absorbing; ++steps) {
        const std::size_t i = Table::index(h);
        h += drift[i] * dt + std::sqrt(2.0 * d[i] * dt) * normal(random);
        h = h > wall ? 2.0 * wall - h : h;
      }
      const double time = static_cast<double>(steps) * dt;
      sum += time;
      squares += time * time;
    }
    const double mean = sum / c.colloids;
    const double error = std::sqrt((squares / c.colloids - mean * mean) / c.colloids);
    EXPECT_NEAR(mean, found.time, 4.0 * error + 0.021 * found.time);
    std::printf("force %g N, barrier %.2f kT: tau %.5g s, %d colloids %.5g +- %.2g s\n",
                c.force, found.barrier_kT, found.time, c.colloids, mean, error);
  }
}

TEST(BarrierEscape, ScalesWithTheViscosityAndFallsWithTheForce) {
  const SurfaceForces forces(small_colloid());
  const PairAnalysis analysis = analyse_pair(forces);
  const double time = barrier_escape(forces, analysis, {1e-3, 0.0}).time;
  EXPECT_NEAR(barrier_escape(forces, analysis, {2e-3, 0.0}).time / time, 2.0, 1e-12);
  double before = std::numeric_limits<double>::infinity();
  for (double force : {0.0, 1e-13, 1e-12, 1e-11, 1e-10}) {
    const BarrierEscape found = barrier_escape(forces, analysis, {1e-3, force});
    EXPECT_LT(found.time, before) << force;
    EXPECT_GT(found.time, 0.0);
    EXPECT_EQ(found.barrier_kT > 0.0, force < analysis.largest_repulsion.force) << force;
    before = found.time;
  }
  // A force that beats every repulsion leaves no barrier and a drift: at most D_bulk.
  const double bulk = forces.thermal_energy() / (6.0 * kPi * 1e-3 * 50e-9);
  EXPECT_GT(before, 1e-9 * forces.thermal_energy() / (bulk * 1e-10));
}

TEST(BarrierEscape, IsInfiniteWhereNothingHoldsOrNothingAttaches) {
  const SurfaceForces forces(small_colloid());
  const PairAnalysis analysis = analyse_pair(forces);
  ASSERT_TRUE(analysis.secondary_minimum.has_value());
  const double tear = 2.0 * analysis.secondary_pull_off.force;
  EXPECT_TRUE(std::isinf(barrier_escape(forces, analysis, {1e-3, -tear}).time));
  SurfacePair repelling = small_colloid();
  repelling.hamaker = -1e-20;
  const SurfaceForces only_repulsion(repelling);
  EXPECT_TRUE(std::isinf(
      barrier_escape(only_repulsion, analyse_pair(only_repulsion), {1e-3, 1e-12}).time));
  EXPECT_THROW(barrier_escape(forces, analysis, {0.0, 0.0}), InputError);
}

// A held partner 19 times as large is nearly a plate.  Derjaguin's radius, and so the
// curve, is 19/20 of the plate's: 5 % of at most 2.6 kT and of the well's half a kT; the
// resistance differs by as much, which is another 5 %.
TEST(BarrierEscape, TakesALargePartnerForAPlate) {
  SurfacePair two = small_colloid();
  two.shape = PairShape::two_spheres;
  two.double_layer = DoubleLayerForm::constant_potential;
  two.other_radius = 19.0 * two.radius;
  const SurfaceForces spheres(two);
  const SurfaceForces plate(small_colloid());
  const double force = 1e-12;
  const BarrierEscape a = barrier_escape(spheres, analyse_pair(spheres), {1e-3, force});
  const BarrierEscape b = barrier_escape(plate, analyse_pair(plate), {1e-3, force});
  EXPECT_NEAR(std::log(a.time / b.time), 0.0, 0.05 * (2.6 + 0.5) + 0.05);
  EXPECT_NE(a.time, b.time);
}

}  // namespace
}  // namespace colloid
