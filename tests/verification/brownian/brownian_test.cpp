// Brownian motion through the integrator: see README.md beside this file.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/random.h"
#include "motion_cases.h"

namespace colloid {
namespace {

using cases::kDrag;
using cases::kKelvin;
using cases::kRadius;

constexpr double kThermal = kBoltzmann * kKelvin;
constexpr double kDiffusivity = kThermal / kDrag;

class Heat {
 public:
  explicit Heat(std::uint64_t seed) : random_(seed) {}

  Forcing forcing(const OneWayMotion& model, const std::vector<RigidBody>& bodies,
                  double step) {
    std::vector<Vector6> normals;
    normals.reserve(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      Vector6 six;
      for (int pair = 0; pair < 3; ++pair) {
        const auto draws = random_.normal_pair({RandomPurpose::brownian, 0, index_++});
        six[2 * pair] = draws[0];
        six[2 * pair + 1] = draws[1];
      }
      normals.push_back(six);
    }
    return {model.thermal_wrenches(bodies, normals, kKelvin, step), step};
  }

 private:
  Random random_;
  std::uint64_t index_ = 0;
};

// Stokes & Einstein: <x^2> = 6 D t.  The relative standard error of M independent
// squared displacements is sqrt(2/(3 M)); four of them are passed once in 16000.
TEST(Brownian, MeanSquareDisplacementIsSixDt) {
  const cases::Setting setting(cases::free_of_hindrance(1e-3 * kRadius), cases::at_rest,
                               cases::wide_box(1e-3), {});
  constexpr int kDraws = 20000;
  const double step = 0.005 * kRadius * kRadius / kDiffusivity;
  Integrator integrator = setting.integrator(1e-3);
  Heat heat(11);
  std::vector<RigidBody> bodies{cases::colloid_at({5e-4, 5e-4, 5e-4})};
  Vec3 squares;
  double cross_term = 0.0;
  for (int n = 0; n < kDraws; ++n) {
    const Vec3 before = bodies[0].centre;
    const double taken =
        integrator.advance(bodies, 1e9, heat.forcing(*setting.model, bodies, step));
    ASSERT_DOUBLE_EQ(taken, step);
    const Vec3 d = bodies[0].centre - before;
    squares += Vec3{d.x * d.x, d.y * d.y, d.z * d.z};
    cross_term += d.x * d.y;
  }
  const double unit = 2.0 * kDiffusivity * step * kDraws;
  const double sum = squares.x + squares.y + squares.z;
  std::printf("<r^2> / 6 D t = %.4f\n", sum / (3.0 * unit));
  EXPECT_NEAR(sum / (3.0 * unit), 1.0, 4.0 * std::sqrt(2.0 / (3.0 * kDraws)));
  EXPECT_NEAR(squares.x / unit, 1.0, 4.0 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(cross_term / unit, 0.0, 4.0 / std::sqrt(kDraws));
}

// Two colloids that move as one: <u(0).u(t)> = exp(-2 D_r t) for their axis u, with the
// resistance 2 (8 pi mu a^3 + 6 pi mu a l^2) to turns across it, arms l.
TEST(Brownian, DumbbellTurnsAsItsResistanceSays) {
  const cases::Setting setting(cases::free_of_hindrance(1e-3 * kRadius), cases::at_rest,
                               cases::wide_box(1e-3), {});
  RigidBody body = joined(cases::colloid_at({5e-4, 5e-4, 5e-4}, 0),
                          cases::colloid_at({5e-4, 5e-4, 5e-4 + 2.001 * kRadius}, 1), {});
  const double arm = 0.5 * 2.001 * kRadius;
  const double rate =
      kThermal / (2.0 * (kDrag * 4.0 / 3.0 * kRadius * kRadius + kDrag * arm * arm));
  constexpr int kDraws = 10000;
  const double step = 0.005 / rate;
  Integrator integrator = setting.integrator(1e-3);
  Heat heat(12);
  std::vector<RigidBody> bodies{body};
  double turned = 0.0;
  double moved = 0.0;
  for (int n = 0; n < kDraws; ++n) {
    const Vec3 u = bodies[0].arms[0] * (1.0 / arm);
    const Vec3 before = bodies[0].centre;
    integrator.advance(bodies, 1e9, heat.forcing(*setting.model, bodies, step));
    turned += 1.0 - dot(u, bodies[0].arms[0]) / arm;
    moved += dot(bodies[0].centre - before, bodies[0].centre - before);
  }
  // 1 - cos is exponential with mean 1 - exp(-2 D_r t): relative error 1/sqrt(M).  The
  // step's own order: 0.01^2.
  const double expected = (1.0 - std::exp(-2.0 * rate * step)) * kDraws;
  std::printf("dumbbell: turn %.4f, shift %.4f of the expected\n", turned / expected,
              moved / (3.0 * kDiffusivity * step * kDraws));
  EXPECT_NEAR(turned / expected, 1.0, 4.0 / std::sqrt(kDraws) + 1e-3);
  EXPECT_NEAR(moved / (3.0 * kDiffusivity * step * kDraws), 1.0,
              4.0 * std::sqrt(2.0 / (3.0 * kDraws)));
}

// Time spent at gaps within [0.2, 0.4] a over that within [0.6, 0.8] a, and its standard
// error from blocks.  Between a wall that hinders and a plane that only reflects.
struct Occupation {
  double ratio = 0.0;
  double error = 0.0;
};
Occupation occupation(double weight, double fineness, int steps, std::uint64_t seed) {
  OneWayOptions options = cases::free_of_hindrance(0.02 * kRadius);
  options.wall_hindrance = true;
  options.rules.grains_attach = false;
  options.weight = {0.0, 0.0, -weight};
  const cases::Setting setting(
      options, cases::at_rest,
      cases::box_on_wall(1e-3, 3.0 * kRadius, FaceCondition::symmetry), {});
  Integrator integrator = setting.integrator(1e-3);
  Heat heat(seed);
  std::vector<RigidBody> bodies{cases::colloid_at({5e-4, 5e-4, 1.5 * kRadius})};
  constexpr int kBlocks = 40;
  std::vector<double> low(kBlocks), high(kBlocks);
  for (int n = 0; n < steps; ++n) {
    const double gap = bodies[0].centre.z / kRadius - 1.0;
    const double step =
        0.5 * fineness * fineness * gap * kRadius * kRadius / kDiffusivity;
    const double taken =
        integrator.advance(bodies, 1e9, heat.forcing(*setting.model, bodies, step));
    const auto block = static_cast<std::size_t>(n * static_cast<long>(kBlocks) / steps);
    low[block] += gap > 0.2 && gap < 0.4 ? taken : 0.0;
    high[block] += gap > 0.6 && gap < 0.8 ? taken : 0.0;
  }
  double l = 0.0, h = 0.0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    l += low[b];
    h += high[b];
  }
  Occupation out;
  out.ratio = l / h;
  double square = 0.0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    square += std::pow((low[b] - out.ratio * high[b]) / (h / kBlocks), 2);
  }
  out.error = std::sqrt(square) / kBlocks;
  return out;
}

// Boltzmann: without a force every gap is as likely, whatever the mobility; with a weight
// F the density is exp(-F h/kT).  A motion without the drift kT div M gathers where the
// mobility is low: the density would go like 1/M_n, a ratio of 1.9 instead of 1.
TEST(Brownian, GapsBesideAWallFollowBoltzmann) {
  for (double weight_over_kT : {0.0, 3.0}) {
    const double w = weight_over_kT;
    const double expected = w == 0.0 ? 1.0
                                     : (std::exp(-0.2 * w) - std::exp(-0.4 * w)) /
                                           (std::exp(-0.6 * w) - std::exp(-0.8 * w));
    for (double fineness : {0.2, 0.1}) {
      const int steps = fineness > 0.15 ? 100000 : 200000;
      const Occupation got = occupation(w * kThermal / kRadius, fineness, steps, 21);
      std::printf("weight %g kT/a, step %g: ratio %.3f +- %.3f, expected %.3f\n", w,
                  fineness, got.ratio, got.error, expected);
      // The sampling error must be small enough to see the drift.
      EXPECT_LT(got.error, 0.15 * expected);
      EXPECT_NEAR(got.ratio, expected, 4.0 * got.error);
    }
  }
}

}  // namespace
}  // namespace colloid
