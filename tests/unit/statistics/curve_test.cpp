// Common grid, mean curve with its two intervals, and the stages read from it.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/mean_curve.h"
#include "statistics/stages.h"

namespace colloid::statistics {
namespace {

TEST(Grid, ASeriesKeepsItsValueUntilTheNext) {
  const StepSeries series{{0.0, 1.0, 2.5}, {10.0, 7.0, 3.0}};
  EXPECT_EQ(on_grid(series, {0.0, 0.9, 1.0, 2.4, 2.5}, false),
            (std::vector<double>{10.0, 10.0, 7.0, 7.0, 3.0}));
  EXPECT_EQ(on_grid(series, {9.0}, true), std::vector<double>{3.0});
  EXPECT_THROW(on_grid(series, {2.6}, false), InvalidSample);
  EXPECT_THROW(on_grid(series, {-0.1}, true), InvalidSample);
}

TEST(Grid, OfSeveralValuesAtOneTimeTheLastCounts) {
  EXPECT_EQ(on_grid({{0.0, 1.0, 1.0}, {3.0, 2.0, 1.0}}, {1.0}, false),
            std::vector<double>{1.0});
}

TEST(Grid, RefusesWhatIsNoSeries) {
  EXPECT_THROW(on_grid({{}, {}}, {0.0}, false), InvalidSample);
  EXPECT_THROW(on_grid({{1.0, 0.0}, {1.0, 1.0}}, {0.5}, false), InvalidSample);
  EXPECT_THROW(on_grid({{0.0, 1.0}, {1.0}}, {0.5}, false), InvalidSample);
  EXPECT_THROW(on_grid({{0.0, 1.0}, {1.0, std::nan("")}}, {0.5}, false), InvalidSample);
  EXPECT_THROW(uniform_grid(0.0, 5), InvalidSample);
  EXPECT_THROW(uniform_grid(1.0, 1), InvalidSample);
  EXPECT_EQ(uniform_grid(2.0, 3), (std::vector<double>{0.0, 1.0, 2.0}));
}

TEST(MeanCurve, OfNoneAndOne) {
  EXPECT_TRUE(mean_curve({}, {}).mean.empty());
  const MeanCurve one = mean_curve({{1.0, 2.0}}, {});
  EXPECT_EQ(one.mean, (std::vector<double>{1.0, 2.0}));
  EXPECT_TRUE(one.interval.empty());
  EXPECT_TRUE(one.band.empty());
  EXPECT_FALSE(one.note.empty());
}

// t_{1} at 97.5 % is 12.706; s / sqrt 2 = 1 at the second point, 0 at the first.
TEST(MeanCurve, OfTwo) {
  const MeanCurve two = mean_curve({{5.0, 1.0}, {5.0, 3.0}}, {});
  EXPECT_EQ(two.mean, (std::vector<double>{5.0, 2.0}));
  EXPECT_EQ(two.interval[0].low, 5.0);
  EXPECT_NEAR(two.interval[1].high, 2.0 + std::tan(0.475 * 3.14159265358979324), 1e-11);
  EXPECT_GE(*two.simultaneous_factor, *two.pointwise_factor);
}

TEST(MeanCurve, OfEqualCurvesHasABandOfNoWidth) {
  const MeanCurve found = mean_curve({{1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}}, {});
  EXPECT_EQ(found.band[1].low, 2.0);
  EXPECT_EQ(found.band[1].high, 2.0);
}

// With one point nothing is simultaneous: the factor is t_{n-1} but for the bootstrap's
// own errors, 4 sqrt[0.95 * 0.05 / B] / (2 phi(1.96)) = 0.053 of 10,000 resamples, and
// the sample's kurtosis, below 0.05 at n = 400 evenly spaced normal quantiles.
TEST(MeanCurve, OfOnePointIsStudentsInterval) {
  std::vector<std::vector<double>> curves;
  for (int i = 0; i < 400; ++i) {
    const double u = (i + 0.5) / 400.0;
    curves.push_back({std::log(u / (1.0 - u))});
  }
  BootstrapOptions options;
  options.resamples = 10000;
  const MeanCurve found = mean_curve(curves, options);
  EXPECT_NEAR(*found.simultaneous_factor, *found.pointwise_factor, 0.06);
}

// m independent points: c = Phi^-1[(1 + 0.95^(1/m)) / 2], 2.800 for m = 10 against 1.960.
// Logistic quantiles in different order at each point; Monte Carlo as above, where the
// density of the maximum is higher: 4 sqrt[0.95 * 0.05 / B] / (20 phi(2.8)) = 0.055.
TEST(MeanCurve, BandOfIndependentPointsIsSidaks) {
  std::vector<std::vector<double>> curves(400, std::vector<double>(10));
  for (std::size_t j = 0; j < 10; ++j) {
    for (std::size_t i = 0; i < 400; ++i) {
      const std::size_t order = i * (2 * j + 1) * 7 % 401 * (j + 3) % 401;
      const double u = (static_cast<double>(order % 400) + 0.5) / 400.0;
      curves[i][j] = std::log(u / (1.0 - u));
    }
  }
  BootstrapOptions options;
  options.resamples = 10000;
  EXPECT_NEAR(*mean_curve(curves, options).simultaneous_factor, 2.80, 0.1);
}

TEST(MeanCurve, RefusesCurvesOfDifferentLengthAndNan) {
  EXPECT_THROW(mean_curve({{1.0, 2.0}, {1.0}}, {}), InvalidSample);
  EXPECT_THROW(mean_curve({{1.0, std::nan("")}, {1.0, 2.0}}, {}), InvalidSample);
}

TEST(Stages, SecondEndsWhereTheMeanFallsToTheDiameter) {
  const std::vector<double> time{0.0, 1.0, 2.0, 3.0};
  EXPECT_EQ(*first_fall_to(13.0, time, {40.0, 20.0, 10.0, 12.0}), 1.7);
  EXPECT_EQ(*first_fall_to(40.0, time, {40.0, 20.0, 10.0, 12.0}), 0.0);
  EXPECT_FALSE(first_fall_to(13.0, time, {40.0, 20.0, 15.0, 13.5}));
  EXPECT_FALSE(first_fall_to(13.0, {}, {}));
}

// s rises by 10 a step, falls by 4, then by 0.4 = 4 % of 10 (settled), with or without a
// late change.
TEST(Stages, ThirdEndsWhereTheDeviationHasSettled) {
  const std::vector<double> time{0, 1, 2, 3, 4, 5, 6};
  EXPECT_EQ(*settling_time(time, {0, 10, 20, 16, 15.6, 15.2, 15.2}, 0.05), 3.0);
  EXPECT_FALSE(settling_time(time, {0, 10, 20, 16, 15.6, 15.2, 10.0}, 0.05));
  EXPECT_EQ(*settling_time(time, {0, 10, 20, 16, 15.6, 10.0, 9.9}, 0.05), 5.0);
  // Exactly 5 % is not below it.
  EXPECT_FALSE(settling_time(time, {0, 10, 20, 19.5, 19.0, 18.5, 18.0}, 0.05));
}

// Quiet before the maximum does not count, and a maximum at the end is not past.
TEST(Stages, ThirdEndsAfterTheMaximum) {
  EXPECT_EQ(*settling_time({0, 1, 2, 3, 4}, {0, 0, 0, 10, 10}, 0.05), 3.0);
  EXPECT_EQ(*settling_time({0, 1, 2, 3, 4}, {0, 10, 10.1, 10.2, 10.1}, 0.05), 3.0);
  EXPECT_FALSE(settling_time({0, 1, 2, 3}, {0, 0, 0, 10}, 0.05));
  EXPECT_FALSE(settling_time({0, 1, 2, 3}, {0, 0, 0, 0}, 0.05));
  EXPECT_FALSE(settling_time({0}, {0}, 0.05));
  EXPECT_THROW(settling_time({0, 1}, {0, std::nan("")}, 0.05), InvalidSample);
  EXPECT_THROW(settling_time({0, 0}, {0, 1}, 0.05), InvalidSample);
}

}  // namespace
}  // namespace colloid::statistics
