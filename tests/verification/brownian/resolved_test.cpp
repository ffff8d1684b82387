// Brownian motion in the tier quasi_steady: see README.md beside this file.
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "motion_cases.h"
#include "physics/wall_resistance.h"
#include "tiers/resolved_motion.h"

namespace colloid {
namespace {

using cases::kDrag;
using cases::kKelvin;
using cases::kRadius;

constexpr double kThermal = kBoltzmann * kKelvin;
constexpr double kDiffusivity = kThermal / kDrag;
constexpr int kCellsPerRadius = 2;
constexpr int kEdge = 6;    // radii, periodic along the wall
constexpr int kHeight = 3;  // radii, wall below, a plane without shear above

Box slit() {
  Box box;
  box.size = {kEdge * kRadius, kEdge * kRadius, kHeight * kRadius};
  box.faces = {FaceCondition::periodic, FaceCondition::periodic, FaceCondition::periodic,
               FaceCondition::periodic, FaceCondition::wall,     FaceCondition::symmetry};
  return box;
}

// So slow (Pe 0.5) that heat moves the colloid; a solve needs some flow to be compared
// with when the weight rests on the wall.
StokesProblem slow_liquid() {
  StokesProblem problem;
  problem.drive.kind = FlowDrive::Kind::body_force;
  problem.drive.body_force.x = 6.0;  // [N/m^3]
  problem.box = slit();
  problem.viscosity = cases::kMu;
  problem.cells = {kEdge * kCellsPerRadius, kEdge * kCellsPerRadius,
                   kHeight * kCellsPerRadius};
  return problem;
}

OneWayOptions beside_the_wall(double weight) {
  OneWayOptions options = cases::free_of_hindrance(0.1 * kRadius);
  options.wall_hindrance = true;
  options.rules.grains_attach = false;
  options.weight = {0.0, 0.0, -weight};
  return options;
}

// A colloid under a weight in a slow stream, resolved, with lubrication.
class Colloid {
 public:
  Colloid(double weight, std::uint64_t seed)
      : setting_(beside_the_wall(weight), cases::at_rest, slit(), {}),
        resolved_({kRadius, 0.5 * kRadius / kCellsPerRadius, kRadius / kCellsPerRadius,
                   1e-3, 1},
                  slow_liquid(), *setting_.model),
        integrator_(steps(), resolved_, setting_.surfaces),
        random_(seed) {}

  // At most `longest`, of which the strength of the wrenches has to know.
  double step(std::vector<RigidBody>& bodies, double longest) {
    if (resolved_.begin_step(bodies, integrator_.contacts(), integrator_.motion())) {
      integrator_.refresh(bodies);
    }
    const double allowed = std::min(longest, resolved_.longest_step(bodies));
    Vector6 normals;
    for (int pair = 0; pair < 3; ++pair) {
      const auto draws = random_.normal_pair({RandomPurpose::brownian, 0, index_++});
      normals[2 * pair] = draws[0];
      normals[2 * pair + 1] = draws[1];
    }
    return integrator_.advance(
        bodies, allowed,
        Forcing{resolved_.thermal_wrenches(bodies, {normals}, kKelvin, allowed),
                allowed});
  }
  void begin(std::vector<RigidBody>& bodies) { integrator_.refresh(bodies); }
  double solves() const {
    NamedValues counts, seconds;
    resolved_.record(counts, seconds);
    return counts.at(0).second;
  }

 private:
  IntegratorOptions steps() const {
    IntegratorOptions options;
    options.radius = kRadius;
    options.rules = setting_.options.rules;
    return options;
  }

  cases::Setting setting_;
  ResolvedMotion resolved_;
  Integrator integrator_;
  Random random_;
  std::uint64_t index_ = 0;
};

// One short step from the same place again and again: <x^2> = 2 kT M t, M of a sphere
// beside a plane (Brenner 1961; Goldman, Cox & Brenner 1967).  Four standard errors, and
// the step's own order: it is 0.02 of the gap.
TEST(ResolvedBrownian, DiffusesBesideAWallAsTheHindranceSays) {
  for (double gap : {0.2, 0.6}) {
    Colloid colloid(kThermal / kRadius, 31);
    constexpr int kDraws = 20000;
    const double step = 2e-4 * gap * gap * kRadius * kRadius / kDiffusivity;
    const Vec3 place{3.1 * kRadius, 2.9 * kRadius, (1.0 + gap) * kRadius};
    double along = 0.0, normal = 0.0;
    for (int n = 0; n < kDraws; ++n) {
      std::vector<RigidBody> bodies{cases::colloid_at(place)};
      colloid.begin(bodies);
      const double taken = colloid.step(bodies, step);
      ASSERT_DOUBLE_EQ(taken, step);
      const Vec3 d = bodies[0].centre - place;
      along += 0.5 * (d.x * d.x + d.y * d.y);
      normal += d.z * d.z;
    }
    const WallResistance w = wall_resistance(gap);
    const double turning = 4.0 / 3.0 * w.t_t * w.t_t / w.t_r;
    const double unit = 2.0 * kDiffusivity * step * kDraws;
    std::printf("gap %g: along %.4f, normal %.4f of the exact diffusivity\n", gap,
                along / unit * (w.f_t - turning), normal / unit * w.f_n);
    EXPECT_NEAR(along / unit * (w.f_t - turning), 1.0, 4.0 / std::sqrt(kDraws) + 0.002);
    EXPECT_NEAR(normal / unit * w.f_n, 1.0, 4.0 * std::sqrt(2.0 / kDraws) + 0.002);
  }
}

// Boltzmann: gaps are distributed like exp(-F h/kT) if the heat's motion has the mobility
// with which the colloid answers the weight, which the resolved flow gives.
TEST(ResolvedBrownian, GapsBesideAWallFollowBoltzmann) {
  constexpr double kWeight = 3.0;  // kT/a
  Colloid colloid(kWeight * kThermal / kRadius, 32);
  std::vector<RigidBody> bodies{
      cases::colloid_at({3.1 * kRadius, 2.9 * kRadius, 1.5 * kRadius})};
  colloid.begin(bodies);
  constexpr int kSteps = 300000;
  constexpr int kBlocks = 40;
  std::vector<double> low(kBlocks), high(kBlocks);
  for (int n = 0; n < kSteps; ++n) {
    const double gap = bodies[0].centre.z / kRadius - 1.0;
    const double step =
        0.5 * 0.04 * std::min(gap, 1.0) * kRadius * kRadius / kDiffusivity;
    const double taken = colloid.step(bodies, step);
    const auto block = static_cast<std::size_t>(n * static_cast<long>(kBlocks) / kSteps);
    low[block] += gap > 0.2 && gap < 0.4 ? taken : 0.0;
    high[block] += gap > 0.6 && gap < 0.8 ? taken : 0.0;
  }
  double l = 0.0, h = 0.0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    l += low[b];
    h += high[b];
  }
  const double ratio = l / h;
  double square = 0.0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    square += std::pow((low[b] - ratio * high[b]) / (h / kBlocks), 2);
  }
  const double error = std::sqrt(square) / kBlocks;
  const double expected = std::exp(0.4 * kWeight);
  std::printf("ratio %.3f +- %.3f, Boltzmann %.3f; %g solves in %d steps\n", ratio, error,
              expected, colloid.solves(), kSteps);
  EXPECT_LT(error, 0.15 * expected);
  EXPECT_NEAR(ratio, expected, 4.0 * error);
}

}  // namespace
}  // namespace colloid
