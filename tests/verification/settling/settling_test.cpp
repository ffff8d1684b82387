// One sphere near a wall or a held sphere: see README.md beside this file.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "motion_cases.h"
#include "physics/pair_resistance.h"

namespace colloid {
namespace {

using cases::kDrag;
using cases::kRadius;

OneWayOptions hindered(double gap) {
  OneWayOptions options = cases::free_of_hindrance(gap);
  options.wall_hindrance = true;
  return options;
}

// Brenner (1961), Chem. Eng. Sci. 16, 242, eq. (2.19).
double brenner(double eps) {
  const double alpha = std::acosh(1.0 + eps);
  double sum = 0.0;
  for (int n = 1; n * alpha < 40.0; ++n) {
    const double m = 2.0 * n + 1.0;
    const double s = 2.0 * std::sinh((n + 0.5) * alpha);
    const double top = 2.0 * std::sinh(m * alpha) + m * std::sinh(2.0 * alpha);
    const double bottom = s * s - std::pow(m * std::sinh(alpha), 2);
    sum += n * (n + 1.0) / ((2.0 * n - 1.0) * (2.0 * n + 3.0)) * (top / bottom - 1.0);
  }
  return 4.0 / 3.0 * std::sinh(alpha) * sum;
}

// Time to settle from gap `from` to `to` (over a), over a / U_0: the integral of f_n,
// Simpson's rule in ln(gap).
double settling_time(double from, double to) {
  constexpr int kPanels = 400;
  const double width = std::log(from / to) / kPanels;
  double sum = 0.0;
  for (int i = 0; i <= kPanels; ++i) {
    const double eps = to * std::exp(i * width);
    const double weight = i == 0 || i == kPanels ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * brenner(eps) * eps;
  }
  return sum * width / 3.0;
}

TEST(Settling, TakesTheTimeOfBrennersResistance) {
  OneWayOptions options = hindered(1e-3 * kRadius);
  options.weight = {0.0, 0.0, -1e-13};
  const double speed = 1e-13 / kDrag;
  const cases::Setting setting(options, cases::at_rest, cases::box_on_wall(1e-4, 1e-4),
                               {});
  constexpr double kFrom = 5.0;
  double last = 0.0;
  for (double tolerance : {1e-3, 1e-5}) {
    Integrator integrator = setting.integrator(tolerance);
    std::vector<RigidBody> bodies{cases::colloid_at({5e-5, 5e-5, (1 + kFrom) * kRadius})};
    double time = 0.0;
    double worst = 0.0;
    for (;;) {
      time += integrator.advance(bodies, 1e3, std::nullopt);
      const double gap = bodies[0].centre.z / kRadius - 1.0;
      if (gap < 2e-3) {
        break;
      }
      const double error = time * speed / kRadius - settling_time(kFrom, gap);
      worst = std::max(worst, std::abs(error));
      // README: each step may err by `tolerance` times the gap, or a where that is less,
      // at the speed U_0/f_n: at most f_n(a) in time; the fit of f_n 3e-7.
      const double per_step = brenner(1.0) * tolerance;
      EXPECT_LT(std::abs(error),
                per_step * static_cast<double>(integrator.counts().steps) + 1e-5)
          << "gap " << gap;
    }
    std::printf("tolerance %g: time off by %.1e a/U_0, %ld steps\n", tolerance, worst,
                integrator.counts().steps);
    if (last > 0.0) {
      EXPECT_LT(worst, 0.1 * last);
    }
    last = worst;
  }
}

TEST(Settling, ReferenceHasPublishedValues) {
  EXPECT_NEAR(brenner(0.5431), 3.03599, 2e-4);
  EXPECT_NEAR(brenner(0.005004), 201.873, 0.05);
}

struct ShearRow {
  double height;  // h/a
  double speed;   // U/(hS)
};

AmbientMotion shear(const Vec3& x, double) {
  return cases::shear_along_x(1.0, x.z);
}

// Goldman, Cox & Brenner (1967) II: free speed of a sphere in shear, digits as printed.
TEST(ShearNearWall, FreeSpeedIsThePublishedOne) {
  const cases::Setting setting(hindered(1e-6 * kRadius), shear,
                               cases::box_on_wall(1e-4, 1e-3), {});
  for (const ShearRow& row :
       {ShearRow{10.0677, 0.99970}, ShearRow{3.7622, 0.99436}, ShearRow{1.5431, 0.92187},
        ShearRow{1.1276, 0.7669}, ShearRow{1.005004, 0.4786}}) {
    const double z = row.height * kRadius;
    const std::vector<RigidBody> bodies{cases::colloid_at({5e-5, 5e-5, z})};
    const Motion motion = setting.model->motion(bodies, {}, {});
    EXPECT_NEAR(motion.velocity[0].x / z, row.speed, 1e-4) << "h/a = " << row.height;
    EXPECT_NEAR(motion.velocity[0].y, 0.0, 1e-18);
    EXPECT_NEAR(motion.velocity[0].z, 0.0, 1e-18);
  }
}

// Speed and spin together, from the exact factors that series.csv of the wall's own
// verification holds: f_t U - (4/3) t_t w = f_s h S, t_r w - t_t U = t_s S/2 (a = 1).
TEST(ShearNearWall, SpeedAndSpinBalanceForceAndTorque) {
  const cases::Setting setting(hindered(1e-7 * kRadius), shear,
                               cases::box_on_wall(1e-4, 1e-3), {});
  std::ifstream file(PORECLOG_SOURCE_DIR
                     "/tests/verification/wall_resistance/series.csv");
  std::string line;
  std::getline(file, line);
  int rows = 0;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::vector<double> c;
    for (std::string field; std::getline(fields, field, ',');) {
      c.push_back(std::stod(field));
    }
    const double height = 1.0 + c[0];
    if (c[0] > 500.0) {
      continue;
    }
    const double ft = c[2], tt = c[3], tr = c[4], fs = c[5], ts = c[6];
    const double det = ft * tr - 4.0 / 3.0 * tt * tt;
    const double speed = (tr * fs * height + 4.0 / 3.0 * tt * ts * 0.5) / det;
    const double spin = (ft * ts * 0.5 + tt * fs * height) / det;
    const std::vector<RigidBody> bodies{
        cases::colloid_at({5e-5, 5e-5, height * kRadius})};
    const Motion motion = setting.model->motion(bodies, {}, {});
    // The factors' fit is good to 4e-6 of its worst; two of them divide.
    EXPECT_NEAR(motion.velocity[0].x / kRadius / speed, 1.0, 2e-5) << "gap " << c[0];
    EXPECT_NEAR(motion.spin[0].y / spin, 1.0, 2e-5) << "gap " << c[0];
    ++rows;
  }
  EXPECT_GT(rows, 10);
}

// A sphere held beside another feels of a stream what both feel when they move as one
// through liquid at rest: 6 pi mu a (x11 + (1 + ratio)/2 x12) U, Jeffrey & Onishi (1984).
TEST(HeldBesideSphere, FeelsWhatBothFeelMovingAsOne) {
  for (double ratio : {1.0, 7.26}) {
    const double b = ratio * kRadius;
    const TwoSphereResistance exact(ratio);
    const Vec3 centre{5e-4, 5e-4, 5e-4};
    for (const Vec3& n : {Vec3{0.0, 0.0, 1.0}, Vec3{0.6, 0.0, -0.8}}) {
      for (double gap : {0.02, 0.1, 0.5, 1.0, 1.9}) {
        const Vec3 u{3e-4, 4e-4, -5e-4};
        const auto flow = [&](const Vec3& x, double a) {
          return cases::stream_past_sphere(u, b, x - centre, a);
        };
        const cases::Setting setting(hindered(1e-3 * kRadius), flow,
                                     cases::wide_box(1e-3), {{centre, b}});
        const Vec3 x = centre + n * (kRadius + b + gap * kRadius);
        const BodyWrench held = setting.model->held_wrenches({cases::colloid_at(x)})[0];
        const double xi = 2.0 * gap / (1.0 + ratio);
        const PairResistance r = exact.at(xi);
        const double mean = 0.5 * (1.0 + ratio);
        const Vec3 along = n * dot(u, n);
        const Vec3 force =
            (along * (r.xa11 + mean * r.xa12) + (u - along) * (r.ya11 + mean * r.ya12)) *
            kDrag;
        // T_1 = pi mu [(2a)^2 yb11 + (a + b)^2 yb12] U x d, d = -n.
        const Vec3 torque = cross(u, n) * (-kPi * cases::kMu * kRadius * kRadius *
                                           (4.0 * r.yb11 + 4.0 * mean * mean * r.yb12));
        // Each function is good to 1e-4 of itself; they nearly cancel at contact.
        const double f_bound =
            1e-4 * kDrag * norm(u) * (r.xa11 + mean * std::abs(r.xa12) + 1.0);
        const double t_bound = 1e-4 * 4.0 * kPi * cases::kMu * kRadius * kRadius *
                               norm(u) *
                               (1.0 + std::abs(r.yb11) + mean * mean * std::abs(r.yb12));
        EXPECT_LT(norm(held.force - force), f_bound)
            << "ratio " << ratio << " gap " << gap;
        EXPECT_LT(norm(held.torque - torque), t_bound)
            << "ratio " << ratio << " gap " << gap;
        EXPECT_GT(norm(force), 10.0 * f_bound);
      }
    }
  }
}

// Hindrance begins without a jump: the speed across the end of its reach is smooth.
TEST(HeldBesideSphere, HindranceSetsInSmoothly) {
  const Vec3 centre{5e-4, 5e-4, 5e-4};
  OneWayOptions options = hindered(1e-3 * kRadius);
  options.weight = {0.0, 0.0, -1e-13};
  const cases::Setting setting(options, cases::at_rest, cases::wide_box(1e-3),
                               {{centre, 7.26 * kRadius}});
  double before = 0.0;
  const double free = 1e-13 / kDrag;
  for (double gap = 4.2; gap > 1.5; gap -= 0.01) {
    const Vec3 x = centre + Vec3{0.0, 0.0, (8.26 + gap) * kRadius};
    const double speed =
        -setting.model->motion({cases::colloid_at(x)}, {}, {}).velocity[0].z / free;
    if (gap > 4.0) {
      EXPECT_NEAR(speed, 1.0, 1e-12);
    } else if (before > 0.0) {
      // A weight that rises over 2 a changes by 0.0075 at most in 0.01 a.
      EXPECT_LT(std::abs(speed - before), 0.0075) << gap;
    }
    before = speed;
  }
  EXPECT_LT(before, 0.75);
}

}  // namespace
}  // namespace colloid
