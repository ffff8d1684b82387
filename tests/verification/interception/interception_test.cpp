// Pure interception in Happel's cell: see README.md beside this file.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "motion_cases.h"

namespace colloid {
namespace {

constexpr double kCollector = 20e-6;  // radius of the collector R_c [m]
constexpr double kSpeed = 1e-3;       // U [m/s]
constexpr double kPorosity = 0.4;
constexpr double kEdge = 8.0 * kCollector;
const Vec3 kCentre{0.5 * kEdge, 0.5 * kEdge, 0.5 * kEdge};

// Happel (1958), AIChE J. 4, 197: stream function (U R_c^2/2) sin^2 theta f(r/R_c), flow
// along +z.
class HappelCell {
 public:
  HappelCell() {
    const double g = inner_over_outer();
    const double w = 2.0 - 3.0 * g + 3.0 * std::pow(g, 5) - 2.0 * std::pow(g, 6);
    k_[0] = 1.0 / w;
    k_[1] = -(3.0 + 2.0 * std::pow(g, 5)) / w;
    k_[2] = (2.0 + 3.0 * std::pow(g, 5)) / w;
    k_[3] = -std::pow(g, 5) / w;
  }
  static double inner_over_outer() { return std::cbrt(1.0 - kPorosity); }

  // f and its derivative.
  double f(double r) const {
    return k_[0] / r + k_[1] * r + k_[2] * r * r + k_[3] * std::pow(r, 4);
  }
  double slope(double r) const {
    return -k_[0] / (r * r) + k_[1] + 2.0 * k_[2] * r + 4.0 * k_[3] * std::pow(r, 3);
  }

  // At x from the centre over R_c, over U.
  Vec3 velocity(const Vec3& x) const {
    const double r = norm(x);
    const Vec3 n = x * (1.0 / r);
    const double along = n.z * f(r) / (r * r);  // u_r
    // u_theta = -sin(theta) slope/(2 r); its direction times sin(theta) is n_z n - e_z.
    const Vec3 turning = n * n.z - Vec3{0.0, 0.0, 1.0};
    return n * along - turning * (slope(r) / (2.0 * r));
  }

 private:
  std::array<double, 4> k_{};
};

// Whether a colloid that enters the cell at `off_axis` over R_c touches the collector.
bool touches(const cases::Setting& setting, double off_axis, double tolerance,
             long& steps) {
  const double outer = 1.0 / HappelCell::inner_over_outer();
  const double height = -std::sqrt(outer * outer - off_axis * off_axis);
  std::vector<RigidBody> bodies{
      cases::colloid_at(kCentre + Vec3{off_axis, 0.0, height} * kCollector)};
  Integrator integrator = setting.integrator(tolerance);
  while (bodies[0].centre.z < kCentre.z + 0.3 * kCollector) {
    integrator.advance(bodies, 1.0, std::nullopt);
    if (!find_touches(bodies, setting.surfaces, setting.options.rules,
                      setting.options.radius)
             .empty()) {
      steps = integrator.counts().steps;
      return true;
    }
  }
  steps = integrator.counts().steps;
  return false;
}

struct Found {
  double efficiency = 0.0;
  long steps = 0;
};

// The limiting distance off the axis, by bisection, squared.
Found efficiency(double interception, double tolerance) {
  const HappelCell cell;
  OneWayOptions options = cases::free_of_hindrance(0.0);
  constexpr double kGap = 0.01;  // of contact, over a: a + gap = N_R R_c
  options.radius = interception * kCollector / (1.0 + kGap);
  options.rules.grain_gap = kGap * options.radius;
  const auto flow = [&](const Vec3& x, double) {
    return AmbientMotion{cell.velocity((x - kCentre) * (1.0 / kCollector)) * kSpeed, {}};
  };
  const cases::Setting setting(options, flow, cases::wide_box(kEdge),
                               {{kCentre, kCollector}});
  Found found;
  double inside = 0.0;
  double outside = 1.0;
  while (outside - inside > 1e-9) {
    const double middle = 0.5 * (inside + outside);
    if (touches(setting, middle, tolerance, found.steps)) {
      inside = middle;
    } else {
      outside = middle;
    }
  }
  found.efficiency = inside * inside;
  return found;
}

struct Case {
  double interception;  // N_R
  double exact;         // eta
};

class Happel : public ::testing::TestWithParam<Case> {};

TEST_P(Happel, LimitingTrajectoryGivesTheExactEfficiency) {
  const Case& c = GetParam();
  for (double tolerance : {1e-3, 1e-5, 1e-7}) {
    const Found found = efficiency(c.interception, tolerance);
    const double error = found.efficiency / c.exact - 1.0;
    std::printf("N_R %g  tolerance %g: eta %.6e, error %+.1e, %ld steps\n",
                c.interception, tolerance, found.efficiency, error, found.steps);
    // README: 2 tolerance per step, the last digit of the reference, and the tolerance
    // of contact, 1e-3 of its gap, 1e-2 a.
    const double bound = 2.0 * tolerance * static_cast<double>(found.steps) + 1e-5 + 2e-5;
    EXPECT_LT(std::abs(error), bound);
  }
}

// The exact efficiency f(1 + N_R), porosity 0.4, from an independent evaluation.
INSTANTIATE_TEST_SUITE_P(Ratios, Happel,
                         ::testing::Values(Case{0.01, 5.6074e-3}, Case{0.05, 0.13132}),
                         [](const ::testing::TestParamInfo<Case>& instance) {
                           return instance.index == 0 ? "OneHundredth" : "OneTwentieth";
                         });

// A straight path that dips into the gap of contact for less than a step, the ends of the
// step well outside: the touch is found whatever gaps other surfaces have.
TEST(Contact, IsFoundWithinAStepThatGrazesAGrain) {
  for (double colloid_gap : {1e-4, 1e-1}) {
    OneWayOptions options = cases::free_of_hindrance(1e-3 * cases::kRadius);
    options.rules.colloid_gap = colloid_gap * cases::kRadius;
    const double a = options.radius;
    const double grain = 10.0 * a;
    const auto flow = [](const Vec3&, double) {
      return AmbientMotion{{1e-3, 0.0, 0.0}, {}};
    };
    const cases::Setting setting(options, flow, cases::wide_box(kEdge),
                                 {{kCentre, grain}});
    // The step of 0.5 a is symmetric about the grain; the dip at its middle is 1e-3 a
    // deep, its ends are (0.25 a)^2/(2 x 11 a) - 1e-3 a = 1.8e-3 a outside.
    const double height = grain + a + options.rules.grain_gap - 1e-3 * a;
    std::vector<RigidBody> bodies{
        cases::colloid_at(kCentre + Vec3{-0.25 * a, 0.0, height})};
    Integrator integrator = setting.integrator(1e-3);
    integrator.advance(bodies, 1.0, std::nullopt);
    EXPECT_EQ(integrator.counts().located, 1);
    EXPECT_NEAR(norm(bodies[0].centre - kCentre) - grain - a, options.rules.grain_gap,
                1.01 * kContactTolerance * options.rules.grain_gap);
    // The first of two crossings, x^2 = (R + a + gap)^2 - height^2.
    const double reach = grain + a + options.rules.grain_gap;
    EXPECT_NEAR(bodies[0].centre.x - kCentre.x,
                -std::sqrt(reach * reach - height * height), 1e-3 * a);
  }
}

// The flow coded here: no slip, no flux through the cell, and the exact efficiency.
TEST(HappelCell, IsTheFlowOfTheReference) {
  const HappelCell cell;
  const double outer = 1.0 / HappelCell::inner_over_outer();
  EXPECT_NEAR(norm(cell.velocity({0.6, 0.0, 0.8})), 0.0, 1e-13);
  const Vec3 n{0.6, 0.0, -0.8};
  EXPECT_NEAR(dot(cell.velocity(n * outer), n), -0.8, 1e-13);
  EXPECT_NEAR(cell.f(1.01) / 5.6074e-3, 1.0, 1e-5);
  EXPECT_NEAR(cell.f(1.05) / 0.13132, 1.0, 4e-5);
}

}  // namespace
}  // namespace colloid
