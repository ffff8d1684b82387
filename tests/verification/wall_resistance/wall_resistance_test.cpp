// Problem    a sphere near a plane wall: eight resistance factors against the gap.
// Reference  (a) Brenner's (1961) and Jeffery's (1915) series, summed here;
//            (b) fundamental_solutions.csv: rings of Stokeslets with Blake's images,
//            strengths by
//                least squares, which knows nothing of bispherical coordinates;
//            (c) series.csv: the bispherical series that the fit was made from, at other
//                gaps: measures the fit, not the series;
//            (d) published values and limits.
// Tolerance  derived at each test.
#include "physics/wall_resistance.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "csv_rows.h"

namespace colloid {
namespace {

// Of the fit, relative, stated in wall_resistance.h.
constexpr double kFit = 3e-7;
constexpr double kFitCoupling = 4e-6;

// Columns 1 to 8 of both files: f_n, f_t, t_t, t_r, f_s, t_s, t_n, f_e.
std::vector<double> as_columns(const WallResistance& r) {
  return {r.f_n, r.f_t, r.t_t, r.t_r, r.f_s, r.t_s, r.t_n, r.f_e};
}
constexpr int kCoupling = 2;

// Brenner (1961), Chem. Eng. Sci. 16, 242, eq. (2.19), summed until a term is negligible.
double brenner_series(double eps) {
  const long double alpha = std::acosh(1.0L + eps);
  const long double sinh_alpha = std::sinh(alpha);
  long double sum = 0.0L;
  for (int n = 1; n * alpha < 60.0L; ++n) {
    const long double b = (n + 0.5L) * alpha;
    const long double m = 2.0L * n + 1.0L;
    const long double top = 2.0L * std::sinh(2.0L * b) + m * std::sinh(2.0L * alpha);
    const long double s = 2.0L * std::sinh(b);
    const long double bottom = s * s - m * m * sinh_alpha * sinh_alpha;
    sum +=
        n * (n + 1.0L) / ((2.0L * n - 1.0L) * (2.0L * n + 3.0L)) * (top / bottom - 1.0L);
  }
  return static_cast<double>(4.0L / 3.0L * sinh_alpha * sum);
}

// Jeffery (1915), Proc. London Math. Soc. 14, 327: sphere spinning about the normal.
double jeffery_series(double eps) {
  const long double alpha = std::acosh(1.0L + eps);
  long double sum = 0.0L;
  for (int n = 1; n * alpha < 60.0L; ++n) {
    const long double q = std::sinh(alpha) / std::sinh(n * alpha);
    sum += q * q * q;
  }
  return static_cast<double>(sum);
}

// Long double loses alpha^-3 eps_machine in `bottom`: 1e-10 at eps = 1e-6.
TEST(WallResistance, NormalMotionIsBrennersAndJefferysSeries) {
  for (double eps = 1e-6; eps < 1e3; eps *= 1.7) {
    const WallResistance r = wall_resistance(eps);
    EXPECT_NEAR(r.f_n / brenner_series(eps), 1.0, kFit) << eps;
    EXPECT_NEAR(r.t_n / jeffery_series(eps), 1.0, kFit) << eps;
  }
}

// The residual of the surface velocity, relative to the sphere's, is a column of the
// file. Force and torque are functionals of the surface velocity with weights of order
// one (the tractions of the rigid motions, all of one sign in the mean but peaked at the
// gap), so an oscillating residual enters with at most its own size.  f_r, column 10,
// tests reciprocity.
TEST(WallResistance, AgreesWithFundamentalSolutions) {
  const auto rows = csv_rows("wall_resistance/fundamental_solutions.csv");
  ASSERT_EQ(rows.size(), 5u);
  for (const auto& row : rows) {
    const double eps = row[0];
    const double residual = row[9];
    ASSERT_LT(residual, 1e-6);
    const WallResistance r = wall_resistance(eps);
    const std::vector<double> found = as_columns(r);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], row[i + 1], residual * std::max(1.0, found[i]) + kFit)
          << "eps " << eps << " column " << i;
    }
    EXPECT_NEAR(4.0 / 3.0 * r.t_t, row[10], residual + kFit) << eps;
  }
}

TEST(WallResistance, FitHoldsBetweenTheGapsItWasMadeFrom) {
  const auto rows = csv_rows("wall_resistance/series.csv");
  ASSERT_EQ(rows.size(), 27u);
  std::vector<double> largest(8, 0.0);
  for (const auto& row : rows) {
    const std::vector<double> found = as_columns(wall_resistance(row[0]));
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double error = std::abs(found[i] / row[i + 1] - 1.0);
      largest[i] = std::max(largest[i], error);
      EXPECT_LT(error, i == kCoupling ? kFitCoupling : kFit)
          << "eps " << row[0] << " column " << i;
    }
  }
  const char* names[] = {"f_n", "f_t", "t_t", "t_r", "f_s", "t_s", "t_n", "f_e"};
  for (std::size_t i = 0; i < largest.size(); ++i) {
    std::printf("%s: largest relative error %.1e\n", names[i], largest[i]);
  }
}

// Goldman, Cox & Brenner (1967) and the reference numbers of the project: each to half a
// unit of its last digit.
TEST(WallResistance, ReproducesPublishedTable) {
  struct Line {
    double height, f_n, f_t, f_s, speed;
    double speed_digit;
  };
  for (const Line& line : {Line{10.0677, 1.12525, 1.05906, 1.0587, 0.99970, 5e-6},
                           Line{3.7622, 1.41287, 1.17381, 1.1671, 0.99436, 5e-6},
                           Line{1.5431, 3.03599, 1.56745, 1.4391, 0.92187, 5e-6},
                           Line{1.1276, 9.25339, 2.15158, 1.6160, 0.7669, 5e-5},
                           Line{1.005004, 201.873, 3.78631, 1.6969, 0.4786, 5e-5}}) {
    const double eps = line.height - 1.0;
    const WallResistance r = wall_resistance(eps);
    // The heights are cosh(3), cosh(2), ... rounded to 5e-5 (1e-6 the last): f_n, of
    // slope 1/eps^2, feels that.
    const double rounding = line.height < 1.01 ? 1e-6 : 5e-5;
    EXPECT_NEAR(
        r.f_n, line.f_n,
        0.55 * std::pow(10.0, line.f_n > 100.0 ? -3 : -5) + rounding / (eps * eps));
    EXPECT_NEAR(r.f_t, line.f_t, 0.5e-5 + rounding * 0.54 / eps);
    EXPECT_NEAR(r.f_s, line.f_s, 0.5e-4 + rounding);
    EXPECT_NEAR(free_in_shear(eps).speed, line.speed,
                line.speed_digit + rounding * 0.2 / eps);
  }
}

// The log terms of lubrication theory, seen as the change over one decade: what remains
// is of order eps ln(1/eps), here 1e-5 times at most 10.
TEST(WallResistance, HasTheLogarithmsOfLubricationTheory) {
  const WallResistance near = wall_resistance(1e-6);
  const WallResistance far = wall_resistance(1e-5);
  const double decade = std::log(10.0);
  EXPECT_NEAR((near.f_n - 1e6) - (far.f_n - 1e5), decade / 5.0, 1e-4);
  EXPECT_NEAR(near.f_t - far.f_t, decade * 8.0 / 15.0, 1e-4);
  EXPECT_NEAR(near.t_t - far.t_t, decade / 10.0, 1e-4);
  EXPECT_NEAR(near.t_r - far.t_r, decade * 2.0 / 5.0, 1e-4);
}

// Constants at contact: f_n of Cox & Brenner (1967), f_s and t_s of O'Neill (1968), which
// are exact for a touching sphere; t_n is zeta(3).  The remainder at eps = 1e-9 is
// nothing.  Goren & O'Neill (1971): f_e (1 + 1/3) = 3.23 for a touching sphere.
TEST(WallResistance, HasTheConstantsOfContact) {
  const WallResistance r = wall_resistance(1e-9);
  EXPECT_NEAR(r.f_n - 1e9 - std::log(1e9) / 5.0, 0.97128, 2e-5);
  EXPECT_NEAR(r.f_s, 1.7005, 2e-4);  // O'Neill prints 1.7009, Goldman et al. 1.7005
  EXPECT_NEAR(r.t_s, 0.94399, 1e-5);
  EXPECT_NEAR(r.t_n, 1.2020569, kFit);
  EXPECT_NEAR(r.f_e * 4.0 / 3.0, 3.23, 5e-3);
}

// Reflections: f_n to x^3, f_t to x^5, t_r = 1 + 5/16 x^3, t_s = 1 - 3/16 x^3,
// t_n = 1/(1 - x^3/8), t_t = (3/32) x^4 (1 - 3/8 x), f_s = 1 + 9/16 x.  f_e is f_n in the
// flow less what the image of the strain's stresslet, 20 pi mu a^3 A H along the normal,
// sends back, (15/8) A a^3/H (a force dipole p: 3p/(32 pi mu H^2), Berke et al. 2008).
// The bound is the next power of x; of t_t it is relative.
TEST(WallResistance, HasTheFarField) {
  for (double height : {20.0, 50.0, 200.0}) {
    const double x = 1.0 / height;
    const WallResistance r = wall_resistance(height - 1.0);
    EXPECT_NEAR(r.f_n, 1.0 / (1.0 - 9.0 / 8.0 * x + std::pow(x, 3) / 2.0),
                std::pow(x, 4) + kFit);
    EXPECT_NEAR(r.f_t,
                1.0 / (1.0 - 9.0 / 16.0 * x + std::pow(x, 3) / 8.0 -
                       45.0 / 256.0 * std::pow(x, 4) - std::pow(x, 5) / 16.0),
                std::pow(x, 6) + kFit);
    EXPECT_NEAR(r.t_t / (3.0 / 32.0 * std::pow(x, 4)), 1.0 - 3.0 / 8.0 * x,
                x * x + kFitCoupling);
    EXPECT_NEAR(r.t_r, 1.0 + 5.0 / 16.0 * std::pow(x, 3), std::pow(x, 4) + kFit);
    EXPECT_NEAR(r.t_s, 1.0 - 3.0 / 16.0 * std::pow(x, 3), std::pow(x, 4) + kFit);
    EXPECT_NEAR(r.f_s, 1.0 + 9.0 / 16.0 * x, x * x + kFit);
    EXPECT_NEAR(r.t_n, 1.0 / (1.0 - std::pow(x, 3) / 8.0), std::pow(x, 5) + kFit);
    EXPECT_NEAR(r.f_e,
                (1.0 - 15.0 / 8.0 * std::pow(x, 3)) /
                    (1.0 - 9.0 / 8.0 * x + std::pow(x, 3) / 2.0),
                std::pow(x, 4) + kFit);
  }
}

TEST(WallResistance, IsTheBulkAtInfinityAndFiniteAtTheSmallestGap) {
  const WallResistance bulk = wall_resistance(std::numeric_limits<double>::infinity());
  const std::vector<double> expected = {1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  const std::vector<double> found = as_columns(bulk);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], kFit) << i;
  }
  EXPECT_NEAR(free_in_shear(1e6).speed, 1.0, 1e-6);
  for (double eps : {1e-300, 1e-12, 1e300}) {
    for (double factor : as_columns(wall_resistance(eps))) {
      EXPECT_TRUE(std::isfinite(factor)) << eps;
    }
    EXPECT_TRUE(std::isfinite(free_in_shear(eps).speed)) << eps;
    EXPECT_TRUE(std::isfinite(free_in_shear(eps).spin)) << eps;
  }
}

// A passive liquid: the matrix of (R1) for U_x and omega_y is positive definite.
TEST(WallResistance, DissipatesEnergyAtEveryGap) {
  for (double eps = 1e-9; eps < 1e4; eps *= 1.3) {
    const WallResistance r = wall_resistance(eps);
    EXPECT_GT(3.0 / 4.0 * r.f_t * r.t_r, r.t_t * r.t_t) << eps;
    const FreeMotion motion = free_in_shear(eps);
    EXPECT_GT(motion.speed, 0.0);
    EXPECT_LE(motion.speed, 1.0 + kFit);
    EXPECT_GT(motion.spin, 0.0);
    EXPECT_LE(motion.spin, 1.0 + kFit);
  }
}

}  // namespace
}  // namespace colloid
