// The fits where no package's answer is the reference: too few points, exact lines, all
// or none censored, rates that run away.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/censored_fit.h"
#include "statistics/exponential_curve.h"
#include "statistics/exponential_fit.h"
#include "statistics/linear_fit.h"

namespace colloid::statistics {
namespace {

TEST(LinearFit, NeedsTwoPointsAndThreeForIntervals) {
  EXPECT_FALSE(linear_fit({}, {}, 0.95).slope);
  EXPECT_FALSE(linear_fit({1.0}, {1.0}, 0.95).slope);
  EXPECT_FALSE(linear_fit({1.0, 1.0, 1.0}, {1.0, 2.0, 3.0}, 0.95).slope);
  const LinearFit two = linear_fit({1.0, 3.0}, {1.0, 5.0}, 0.95);
  EXPECT_EQ(*two.slope, 2.0);
  EXPECT_EQ(*two.intercept, -1.0);
  EXPECT_FALSE(two.slope_interval);
  EXPECT_FALSE(two.note.empty());
}

TEST(LinearFit, OfEqualValuesHasNoShareOfVarianceExplained) {
  const LinearFit fit = linear_fit({1.0, 2.0, 3.0}, {0.1, 0.1, 0.1}, 0.95);
  EXPECT_NEAR(*fit.slope, 0.0, 1e-16);
  EXPECT_FALSE(fit.r_squared);
}

TEST(LinearFit, RefusesNanAndUnequalLengths) {
  EXPECT_THROW(linear_fit({1.0, std::nan("")}, {1.0, 2.0}, 0.95), InvalidSample);
  EXPECT_THROW(linear_fit({1.0, 2.0}, {1.0}, 0.95), InvalidSample);
}

std::vector<CensoredPoint> line_with_scatter() {
  std::vector<CensoredPoint> points;
  for (int i = 0; i < 12; ++i) {
    points.push_back({i - 4.0, 3.0 - 0.2 * i + 0.3 * std::sin(7.0 * i), false});
  }
  return points;
}

// Without censoring maximum likelihood is least squares, sigma^2 = SSE / n, and Wald's
// errors are those of least squares times sqrt[(n - 2) / n].
TEST(CensoredFit, WithoutCensoringIsLeastSquares) {
  const std::vector<CensoredPoint> points = line_with_scatter();
  std::vector<double> x;
  std::vector<double> y;
  for (const CensoredPoint& point : points) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  const LinearFit line = linear_fit(x, y, 0.95);
  const CensoredFit fit = censored_fit(points, 0.95);
  const double shrink = std::sqrt(10.0 / 12.0);
  EXPECT_NEAR(*fit.slope, *line.slope, 1e-12);
  EXPECT_NEAR(*fit.intercept, *line.intercept, 1e-12);
  EXPECT_NEAR(*fit.sigma, *line.residual_sd * shrink, 1e-12);
  EXPECT_NEAR(*fit.slope_error, *line.slope_error * shrink, 1e-12);
  EXPECT_NEAR(*fit.intercept_error, *line.intercept_error * shrink, 1e-12);
}

// A bound far below its line says nothing; one far above it cannot be ignored.
TEST(CensoredFit, ABoundCountsForWhatItSays) {
  const CensoredFit plain = censored_fit(line_with_scatter(), 0.95);
  std::vector<CensoredPoint> points = line_with_scatter();
  points.push_back({0.0, -50.0, true});
  const CensoredFit uninformed = censored_fit(points, 0.95);
  EXPECT_NEAR(*uninformed.slope, *plain.slope, 1e-12);
  EXPECT_EQ(uninformed.n_censored, 1u);
  points.back() = {7.0, 50.0, true};
  EXPECT_GT(*censored_fit(points, 0.95).slope, *plain.slope + 0.1);
}

// The same line in seconds and microseconds, degrees and nanodegrees.
TEST(CensoredFit, FollowsTheUnits) {
  std::vector<CensoredPoint> points = line_with_scatter();
  points[2].censored = points[5].censored = points[9].censored = true;
  const CensoredFit fit = censored_fit(points, 0.95);
  for (CensoredPoint& point : points) {
    point.x = 1e9 * (point.x + 5.0);
    point.y *= 1e-6;
  }
  const CensoredFit scaled = censored_fit(points, 0.95);
  EXPECT_NEAR(*scaled.slope / (*fit.slope * 1e-15), 1.0, 1e-9);
  EXPECT_NEAR(*scaled.slope_error / (*fit.slope_error * 1e-15), 1.0, 1e-9);
  EXPECT_NEAR(*scaled.intercept / ((*fit.intercept - 5.0 * *fit.slope) * 1e-6), 1.0,
              1e-9);
}

TEST(CensoredFit, SaysWhyThereIsNone) {
  for (const std::vector<CensoredPoint>& points :
       {std::vector<CensoredPoint>{},
        std::vector<CensoredPoint>{{1, 1, true}, {2, 2, true}, {3, 3, true}},
        std::vector<CensoredPoint>{{1, 1, false}, {2, 2, false}, {3, 3, true}},
        std::vector<CensoredPoint>{{1, 1, false}, {1, 2, false}, {1, 4, false}},
        std::vector<CensoredPoint>{{1, 1, false}, {2, 2, false}, {3, 3, false}}}) {
    const CensoredFit fit = censored_fit(points, 0.95);
    EXPECT_FALSE(fit.slope);
    EXPECT_FALSE(fit.note.empty());
  }
  EXPECT_THROW(censored_fit({{1, std::nan(""), false}}, 0.95), InvalidSample);
}

std::vector<double> exponential_at(const std::vector<double>& x, double amplitude,
                                   double rate) {
  std::vector<double> y;
  for (double value : x) {
    y.push_back(amplitude * std::exp(rate * value));
  }
  return y;
}

// Exact data from starts far off; x far from zero too.
TEST(ExponentialCurve, FindsExactParametersFromPoorStarts) {
  const std::vector<double> x{1.0, 1.5, 2.0, 3.0, 4.0, 4.5};
  for (double rate : {-2.0, -0.1, 0.0, 0.3, 2.0}) {
    for (double start_rate : {-3.0, 0.0, 1.0}) {
      const auto found =
          fit_exponential_curve(x, exponential_at(x, 0.7, rate), {1.0, start_rate});
      ASSERT_TRUE(found) << rate << " from " << start_rate;
      EXPECT_NEAR(found->rate, rate, 1e-8);
      EXPECT_NEAR(found->amplitude, 0.7, 1e-8);
    }
  }
}

TEST(ExponentialCurve, HasNoMinimumWhenOnePointHoldsAll) {
  EXPECT_FALSE(fit_exponential_curve({0.0, 0.5, 1.0}, {0.0, 0.0, 1.0}, {0.1, 1.0}));
  EXPECT_FALSE(fit_exponential_curve({1.0, 1.0}, {1.0, 2.0}, {1.0, 0.0}));
}

TEST(ExponentialFit, SaysWhyThereIsNone) {
  const std::vector<double> x{1.0, 2.0, 3.0};
  for (const std::vector<std::vector<double>>& rows :
       {std::vector<std::vector<double>>{}, std::vector<std::vector<double>>{{0, 0, 0}},
        std::vector<std::vector<double>>{{0, 1, 0}, {0, 1, 0}}}) {
    const ExponentialFit fit = exponential_fit(x, rows, {});
    EXPECT_FALSE(fit.rate);
    EXPECT_FALSE(fit.note.empty());
  }
  EXPECT_FALSE(exponential_fit({1.0, 2.0}, {{0.5, 0.5}}, {}).rate);
  EXPECT_THROW(exponential_fit(x, {{1.0, 2.0}}, {}), InvalidSample);
  EXPECT_THROW(exponential_fit(x, {{1.0, 2.0, std::nan("")}}, {}), InvalidSample);
}

TEST(ExponentialFit, OneRealisationHasAFitAndNoInterval) {
  const std::vector<double> x{1.0, 2.0, 3.0, 4.0};
  const ExponentialFit fit = exponential_fit(x, {exponential_at(x, 2.0, -0.5)}, {});
  EXPECT_NEAR(*fit.rate, -0.5, 1e-9);
  EXPECT_NEAR(*fit.r_squared, 1.0, 1e-12);
  EXPECT_FALSE(fit.rate_interval);
}

// Every row is one point of the profile, so a few rows leave most resamples without a
// fit: the interval is withheld, not made of those that happen to have one.
TEST(ExponentialFit, WithholdsTheIntervalWhenResamplesFail) {
  const ExponentialFit fit = exponential_fit(
      {1.0, 2.0, 3.0, 4.0}, {{1, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}}, {});
  ASSERT_TRUE(fit.rate);
  EXPECT_GT(fit.failed_resamples, 0u);
  EXPECT_FALSE(fit.rate_interval);
  EXPECT_FALSE(fit.note.empty());
}

}  // namespace
}  // namespace colloid::statistics
