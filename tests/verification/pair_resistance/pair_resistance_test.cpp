// Problem    two spheres: sixteen resistance functions against the gap.
// Reference  (a) the bispherical solution of Stimson & Jeffery (1926) and Maude (1961)
// for
//                motion along the line of centres and of Jeffery (1915) for spin about
//                it, unequal spheres, summed in bispherical.h;
//            (b) fundamental_solutions.csv: rings of Stokeslets in both spheres, least
//            squares; (c) published values: Jeffrey & Onishi (1984), the project's
//            reference numbers.
// Tolerance  of the expression, as stated in README.md: kError, relative, or absolute
// where
//            the function is below 1; and what the reference adds.
#include "physics/pair_resistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bispherical.h"
#include "core/error.h"

namespace colloid {
namespace {

constexpr double kError = 1e-4;        // any ratio from 0.1 to 10
constexpr double kErrorApart = 1e-7;   // gaps from 0.1: the truncated terms are (2/s)^150
constexpr double kErrorEqual = 3e-5;   // equal spheres
constexpr double kErrorSpin20 = 2e-3;  // xc11 at a ratio of 20

void expect_close(double found, Real expected, double error, const char* name,
                  double ratio, double gap) {
  const auto value = static_cast<double>(expected);
  EXPECT_NEAR(found, value, error * std::max(1.0, std::abs(value)))
      << name << " ratio " << ratio << " gap " << gap;
}

double error_at(double ratio) {
  return ratio == 1.0 ? kErrorEqual : kError;
}

TEST(PairResistance, BisphericalReferenceIsStokesLawFarAway) {
  const Bispherical b(1.0, 1e4);
  EXPECT_NEAR(static_cast<double>(axial(b, 1.0L, 0.0L).on_1), 1.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(spin(b, 1.0L, 0.0L).on_1), 1.0, 1e-9);
}

TEST(PairResistance, MotionAlongTheLineOfCentresIsTheBisphericalSolution) {
  for (double ratio : {1.0, 0.3, 7.26, 0.1, 10.0, 20.0}) {
    const TwoSphereResistance resistance(ratio);
    const double error = error_at(ratio);
    for (double gap = 1e-4; gap < 50.0; gap *= 2.3) {
      const Bispherical b(ratio, gap);
      const PairResistance r = resistance.at(gap);
      const Forces one = axial(b, 1.0L, 0.0L);
      const Forces two = axial(b, 0.0L, 1.0L);
      // JO: F_1 = 6 pi mu a_1 xa11 U_1, F_1 = 3 pi mu (a_1 + a_2) xa12 U_2.
      expect_close(r.xa11, one.on_1, error, "xa11", ratio, gap);
      expect_close(r.xa22, two.on_2 / ratio, error, "xa22", ratio, gap);
      expect_close(r.xa12, two.on_1 * 2.0L / (1.0L + ratio), error, "xa12", ratio, gap);
      expect_close(r.xa12, one.on_2 * 2.0L / (1.0L + ratio), error, "xa21", ratio, gap);
    }
  }
}

TEST(PairResistance, SpinAboutTheLineOfCentresIsJefferysSolution) {
  for (double ratio : {1.0, 0.3, 7.26, 0.1, 10.0, 20.0}) {
    const TwoSphereResistance resistance(ratio);
    const double error = ratio == 20.0 ? kErrorSpin20 : error_at(ratio);
    for (double gap = 1e-4; gap < 50.0; gap *= 2.3) {
      const Bispherical b(ratio, gap);
      const PairResistance r = resistance.at(gap);
      const Forces one = spin(b, 1.0L, 0.0L);
      const Forces two = spin(b, 0.0L, 1.0L);
      const Real mean = (1.0L + ratio) / 2.0L;
      expect_close(r.xc11, one.on_1, error, "xc11", ratio, gap);
      expect_close(r.xc22, two.on_2 / (Real(ratio) * ratio * ratio), error, "xc22", ratio,
                   gap);
      expect_close(r.xc12, two.on_1 / (mean * mean * mean), error, "xc12", ratio, gap);
    }
  }
}

// The residual is that of the surface velocity and of reciprocity, relative to the motion
// imposed; forces are linear functionals of it with weights up to the resistance itself.
TEST(PairResistance, AgreesWithFundamentalSolutions) {
  std::ifstream file(PORECLOG_SOURCE_DIR
                     "/tests/verification/pair_resistance/fundamental_solutions.csv");
  std::string line;
  std::getline(file, line);
  int rows = 0;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::vector<double> x;
    for (std::string field; std::getline(fields, field, ',');) {
      x.push_back(std::stod(field));
    }
    ASSERT_EQ(x.size(), 19u);
    const PairResistance r = TwoSphereResistance(x[0]).at(x[1]);
    const double residual = x[18];
    ASSERT_LT(residual, 1e-4);
    const double found[] = {r.xa11, r.xa12, r.xa22, r.ya11, r.ya12, r.ya22,
                            r.xc11, r.xc12, r.xc22, r.yc11, r.yc12, r.yc22,
                            r.yb11, r.yb12, r.yb21, r.yb22};
    for (std::size_t i = 0; i < 16; ++i) {
      expect_close(found[i], x[i + 2], kErrorApart + residual, "column", x[0], x[1]);
    }
    ++rows;
  }
  EXPECT_EQ(rows, 8);
}

// Approaching at U each: force over 6 pi mu a U is xa11 - xa12.  Half a unit of the last
// digit of the numbers quoted, and the error of the expression.
TEST(PairResistance, SqueezingBetweenEqualSpheresIsAsQuoted) {
  const TwoSphereResistance resistance(1.0);
  for (const auto& [s, force, digit] : {std::array<double, 3>{2.01, 53.4223, 5e-5},
                                        std::array<double, 3>{2.1, 7.41330, 5e-6},
                                        std::array<double, 3>{3.0, 2.03865, 5e-6},
                                        std::array<double, 3>{6.0, 1.33015, 5e-6}}) {
    const PairResistance r = resistance.at(s - 2.0);
    EXPECT_NEAR(r.xa11 - r.xa12, force, digit + kErrorEqual) << s;
  }
}

// Jeffrey & Onishi (1984), constants at contact of equal spheres, printed to four
// decimals.
TEST(PairResistance, HasThePublishedConstantsOfContact) {
  const double gap = 1e-9;
  const double log = std::log(1.0 / gap);
  const PairResistance r = TwoSphereResistance(1.0).at(gap);
  const double digit = 5e-5 + kErrorEqual;
  const double pole = 0.25 / gap;
  EXPECT_NEAR(r.xa11 - pole - 9.0 / 40.0 * log, 0.9954, digit);
  EXPECT_NEAR(r.xa12 + pole + 9.0 / 40.0 * log, -0.3502, digit);
  EXPECT_NEAR(r.ya11 - log / 6.0, 0.9983, digit);
  EXPECT_NEAR(r.ya12 + log / 6.0, -0.2737, digit);
  EXPECT_NEAR(r.yb11 + log / 4.0, 0.2390, 2.0 * digit);
  EXPECT_NEAR(r.yc11 - log / 5.0, 0.7028, 2.0 * digit);
  EXPECT_NEAR(r.yc12 - log / 20.0, -0.0275, 2.0 * digit);
  // Touching spheres spin as one: zeta(3, 1/2)/8 and -zeta(3)/8.
  EXPECT_NEAR(r.xc11, 7.0 / 8.0 * 1.2020569, kErrorEqual);
  EXPECT_NEAR(r.xc12, -1.2020569 / 8.0, kErrorEqual);
}

// Leading reflections: xa12 = -(3/2)/s, ya12 = -(3/4)/s, xc12 = -1/s^3, yc12 = +1/(2
// s^3), yb12 = 3/2 / s^2 for equal spheres; the next terms are of relative order 1/s^2.
TEST(PairResistance, HasTheFarField) {
  const double s = 200.0;
  const PairResistance r = TwoSphereResistance(1.0).at(s - 2.0);
  const double order = 10.0 / (s * s);
  EXPECT_NEAR(r.xa11, 1.0 + 9.0 / 4.0 / (s * s), kErrorEqual);
  EXPECT_NEAR(r.ya11, 1.0 + 9.0 / 16.0 / (s * s), kErrorEqual);
  EXPECT_NEAR(r.xa12 * s, -1.5, order * 1.5 + kErrorEqual);
  EXPECT_NEAR(r.ya12 * s, -0.75, order * 0.75 + kErrorEqual);
  EXPECT_NEAR(r.xc12 * s * s * s, -1.0, order + 0.01);
  EXPECT_NEAR(r.yc12 * s * s * s, 0.5, order + 0.2);
}

TEST(PairResistance, IsSymmetricUnderExchangeOfTheSpheres) {
  const TwoSphereResistance one(3.0);
  const TwoSphereResistance two(1.0 / 3.0);
  for (double gap : {1e-5, 1e-2, 1.0}) {
    const PairResistance p = one.at(gap);
    const PairResistance q = two.at(gap);
    EXPECT_NEAR(p.xa11, q.xa22, 1e-9 * p.xa11);
    EXPECT_NEAR(p.xa12, q.xa12, kError * std::abs(p.xa12));
    EXPECT_NEAR(p.ya12, q.ya12, kError);
    EXPECT_NEAR(p.yb12, -q.yb21, kError);
    EXPECT_NEAR(p.yb11, -q.yb22, kError);
    EXPECT_NEAR(p.yc12, q.yc12, kError);
  }
}

// Relative motions dissipate: the 2 x 2 blocks are positive definite.
TEST(PairResistance, DissipatesEnergyAtEveryGap) {
  for (double ratio : {1.0, 0.1, 7.26, 20.0}) {
    const TwoSphereResistance resistance(ratio);
    const double mean = (1.0 + ratio) / 2.0;
    for (double gap = 1e-9; gap < 1e3; gap *= 1.7) {
      const PairResistance r = resistance.at(gap);
      // In units of 6 pi mu a_1, 8 pi mu a_1^3.
      EXPECT_GT(r.xa11 * r.xa22 * ratio, mean * mean * r.xa12 * r.xa12) << gap;
      EXPECT_GT(r.ya11 * r.ya22 * ratio, mean * mean * r.ya12 * r.ya12) << gap;
      const double cube = ratio * ratio * ratio;
      EXPECT_GT(r.xc11 * r.xc22 * cube, std::pow(mean, 6) * r.xc12 * r.xc12) << gap;
      EXPECT_GT(r.yc11 * r.yc22 * cube, std::pow(mean, 6) * r.yc12 * r.yc12) << gap;
    }
  }
}

TEST(PairResistance, IsTheBulkAtInfinityAndRefusesExtremeRatios) {
  const PairResistance r =
      TwoSphereResistance(2.0).at(std::numeric_limits<double>::infinity());
  for (double factor : {r.xa11, r.xa22, r.ya11, r.ya22, r.xc11, r.xc22, r.yc11, r.yc22}) {
    EXPECT_NEAR(factor, 1.0, kError);
  }
  for (double coupling :
       {r.xa12, r.ya12, r.yb11, r.yb12, r.yb21, r.yb22, r.xc12, r.yc12}) {
    EXPECT_NEAR(coupling, 0.0, kError);
  }
  EXPECT_TRUE(std::isfinite(TwoSphereResistance(2.0).at(1e-300).xa11));
  EXPECT_THROW(TwoSphereResistance(0.01), InputError);
  EXPECT_THROW(TwoSphereResistance(std::nan("")), InputError);
}

}  // namespace
}  // namespace colloid
