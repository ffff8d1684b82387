// Problem    every estimator on samples, published or drawn once.
// Reference  R 4.2.2 with package survival 3.5-3: reference.R, which holds the calls and
//            wrote samples.csv and reference_r.csv; SciPy 1.10.1: bca.py.
// Tolerance  derived at each test; R's table has 15 digits.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reference_table.h"
#include "statistics/bootstrap.h"
#include "statistics/censored_fit.h"
#include "statistics/exponential_fit.h"
#include "statistics/kaplan_meier.h"
#include "statistics/linear_fit.h"
#include "statistics/mean_interval.h"
#include "statistics/proportion.h"
#include "statistics/quantile.h"
#include "statistics/restricted_mean.h"

namespace colloid::statistics {
namespace {

const ReferenceTable& samples() {
  static const ReferenceTable table("samples.csv");
  return table;
}

const ReferenceTable& reference() {
  static const ReferenceTable table("reference_r.csv");
  return table;
}

// Fifteen digits printed, and products and sums over at most 228 terms: 228 * 1e-16
// relative, amplified in the log-log interval by at most ln S / S (6 at S = 0.02).
constexpr double kDigits = 1e-12;

void expect_relative(double found, double expected, double tolerance,
                     const std::string& what) {
  EXPECT_NEAR(found, expected, tolerance * std::abs(expected)) << what;
}

class KaplanMeierReference : public testing::TestWithParam<std::string> {
 protected:
  KaplanMeier curve() const {
    const std::vector<double> time = samples().column({GetParam()}, 1);
    const std::vector<double> event = samples().column({GetParam()}, 3);
    std::vector<Observation> observations;
    for (std::size_t i = 0; i < time.size(); ++i) {
      observations.push_back({time[i], event[i] == 1.0});
    }
    return kaplan_meier(observations, 0.95);
  }
};

TEST_P(KaplanMeierReference, CurveAndLogLogInterval) {
  const KaplanMeier found = curve();
  const std::vector<double> time = reference().values(GetParam(), "time");
  const std::vector<double> at_risk = reference().values(GetParam(), "at_risk");
  const std::vector<double> survival = reference().values(GetParam(), "survival");
  const std::vector<double> low = reference().values(GetParam(), "low");
  const std::vector<double> high = reference().values(GetParam(), "high");
  ASSERT_EQ(found.steps.size(), time.size() + 1);  // ours begins with time 0
  int intervals = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const SurvivalStep& step = found.steps[i + 1];
    const std::string where = GetParam() + " at " + std::to_string(time[i]);
    EXPECT_EQ(step.time, time[i]);
    EXPECT_EQ(static_cast<double>(step.at_risk), at_risk[i]) << where;
    expect_relative(step.survival, survival[i], kDigits, where);
    if (step.survival > 0.0 && step.survival < 1.0) {
      expect_relative(step.interval.low, low[i], kDigits, where);
      expect_relative(step.interval.high, high[i], kDigits, where);
      ++intervals;
    }
  }
  EXPECT_GE(intervals, 15) << "too few intervals were compared";
}

// R puts a limit where the curve of limits falls below 1/2, as here; no curve here has a
// level piece at exactly 1/2, where R takes the middle of it.
TEST_P(KaplanMeierReference, MedianAndItsInterval) {
  const MedianTime found = median_time(curve());
  ASSERT_TRUE(found.estimate && found.low && found.high);
  EXPECT_EQ(*found.estimate, reference().value(GetParam(), "median"));
  EXPECT_EQ(*found.low, reference().value(GetParam(), "median_low"));
  EXPECT_EQ(*found.high, reference().value(GetParam(), "median_high"));
}

TEST_P(KaplanMeierReference, RestrictedMeanAndItsError) {
  const RestrictedMean found =
      restricted_mean(curve(), reference().value(GetParam(), "tau"));
  ASSERT_TRUE(found.mean && found.standard_error && found.interval);
  const double mean = reference().value(GetParam(), "restricted_mean");
  const double error = reference().value(GetParam(), "restricted_mean_error");
  expect_relative(*found.mean, mean, kDigits, GetParam());
  expect_relative(*found.standard_error, error, kDigits, GetParam());
  // 1.959963984540054 is the normal quantile (any table); no limit here reaches tau.
  expect_relative(found.interval->low, mean - 1.959963984540054 * error, kDigits, "low");
  expect_relative(found.interval->high, mean + 1.959963984540054 * error, kDigits,
                  "high");
}

INSTANTIATE_TEST_SUITE_P(R, KaplanMeierReference,
                         testing::Values("km_aml", "km_lung", "km_campaign",
                                         "km_all_events"),
                         [](const auto& instance) { return instance.param; });

// Sums of 20 values about 1: round-off only.
TEST(StatisticsReference, StudentInterval) {
  const std::vector<double> sample = samples().column({"t_sleep"}, 1);
  const std::vector<double> levels = reference().values("t_sleep", "level");
  ASSERT_EQ(levels.size(), 3u);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const MeanInterval found = mean_interval(sample, levels[i]);
    ASSERT_TRUE(found.interval);
    expect_relative(*found.mean, reference().value("t_sleep", "mean"), kDigits, "mean");
    expect_relative(*found.sd, reference().value("t_sleep", "sd"), kDigits, "sd");
    // The lower limit at 0.95 is 0.596, a difference of two numbers about 1.
    expect_relative(found.interval->low, reference().values("t_sleep", "low")[i], 1e-11,
                    "low");
    expect_relative(found.interval->high, reference().values("t_sleep", "high")[i],
                    kDigits, "high");
  }
}

TEST(StatisticsReference, SampleQuantile) {
  std::vector<double> sample = samples().column({"t_sleep"}, 1);
  std::sort(sample.begin(), sample.end());
  const std::vector<double> p = reference().values("quantile_sleep", "p");
  const std::vector<double> expected = reference().values("quantile_sleep", "quantile");
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(sample_quantile(sample, p[i]), expected[i], kDigits) << p[i];
  }
}

// Both invert the same incomplete beta function; R's inversion is good to 1e-12 or so,
// so 1e-10.  1e-14 absolute for the limits that are 0.
TEST(StatisticsReference, Proportions) {
  const ReferenceTable& r = reference();
  const std::vector<double> k = r.values("proportion", "k");
  const std::vector<double> n = r.values("proportion", "n");
  ASSERT_EQ(k.size(), 7u);
  for (std::size_t i = 0; i < k.size(); ++i) {
    const auto hits = static_cast<std::size_t>(k[i]);
    const auto trials = static_cast<std::size_t>(n[i]);
    const Interval exact = *clopper_pearson(hits, trials, 0.95).interval;
    const Interval score = *wilson(hits, trials, 0.95).interval;
    const auto near = [&](double found, const char* quantity) {
      const double expected = r.values("proportion", quantity)[i];
      EXPECT_NEAR(found, expected, 1e-10 * expected + 1e-14)
          << quantity << ' ' << hits << " of " << trials;
    };
    near(exact.low, "exact_low");
    near(exact.high, "exact_high");
    near(score.low, "wilson_low");
    near(score.high, "wilson_high");
  }
}

// ols_small_spread has x = 1e6 + 1..8, so that naive sums of squares lose 12 digits and
// sums about the mean none in the slope; x itself carries 1e-16 * 1e6 of its spread.
TEST(StatisticsReference, OrdinaryLeastSquares) {
  for (const auto& [name, tolerance] :
       {std::pair{"ols_cars", 1e-11}, std::pair{"ols_small_spread", 1e-8}}) {
    const LinearFit fit =
        linear_fit(samples().column({name}, 1), samples().column({name}, 2), 0.95);
    ASSERT_TRUE(fit.slope_interval && fit.intercept_interval && fit.r_squared);
    const auto near = [&, name = name, tolerance = tolerance](double found,
                                                              const char* quantity) {
      expect_relative(found, reference().value(name, quantity), tolerance,
                      std::string(name) + ' ' + quantity);
    };
    near(*fit.slope, "slope");
    near(*fit.intercept, "intercept");
    near(*fit.slope_error, "slope_error");
    near(*fit.intercept_error, "intercept_error");
    near(*fit.residual_sd, "residual_sd");
    near(*fit.r_squared, "r_squared");
    near(fit.slope_interval->low, "slope_low");
    near(fit.slope_interval->high, "slope_high");
    near(fit.intercept_interval->low, "intercept_low");
    near(fit.intercept_interval->high, "intercept_high");
  }
}

// survreg stops when ln L gains less than 1e-14 of itself: at a maximum of 70 with unit
// curvature in standard errors that is sqrt(2 * 70e-14) = 1e-6 of a standard error.  The
// errors themselves vary as the parameters do: 1e-6 relative.
TEST(StatisticsReference, CensoredRegression) {
  for (const std::string name : {"tobit_quarter", "tobit_most", "tobit_none"}) {
    const std::vector<double> x = samples().column({name}, 1);
    const std::vector<double> y = samples().column({name}, 2);
    const std::vector<double> event = samples().column({name}, 3);
    std::vector<CensoredPoint> points;
    for (std::size_t i = 0; i < x.size(); ++i) {
      points.push_back({x[i], y[i], event[i] == 0.0});
    }
    const CensoredFit fit = censored_fit(points, 0.95);
    ASSERT_TRUE(fit.slope) << name << ": " << fit.note;
    const double slope_error = reference().value(name, "slope_error");
    const double intercept_error = reference().value(name, "intercept_error");
    EXPECT_NEAR(*fit.slope, reference().value(name, "slope"), 1e-6 * slope_error);
    EXPECT_NEAR(*fit.intercept, reference().value(name, "intercept"),
                1e-6 * intercept_error);
    expect_relative(*fit.sigma, reference().value(name, "sigma"), 1e-6, name);
    expect_relative(*fit.slope_error, slope_error, 1e-6, name);
    expect_relative(*fit.intercept_error, intercept_error, 1e-6, name);
    expect_relative(*fit.log_likelihood, reference().value(name, "log_likelihood"),
                    kDigits, name);
    EXPECT_NEAR(fit.slope_interval->high - *fit.slope, 1.959963984540054 * slope_error,
                2e-6 * slope_error);
  }
}

// The iteration ends when the residuals are orthogonal to both columns to 1e-9, that is
// 1e-9 sqrt(n) of a standard error, itself at most 0.3 of the parameter: 1e-8 holds.  R2
// is second order in that and nls's own 1e-6.
TEST(StatisticsReference, ExponentialLeastSquares) {
  for (const std::string name : {"exp_decay", "exp_growth", "exp_bod"}) {
    const ExponentialFit fit =
        exponential_fit(samples().column({name}, 1), {samples().column({name}, 2)}, {});
    ASSERT_TRUE(fit.amplitude && fit.rate && fit.r_squared) << name << ": " << fit.note;
    expect_relative(*fit.amplitude, reference().value(name, "amplitude"), 1e-8, name);
    expect_relative(*fit.rate, reference().value(name, "rate"), 1e-8, name);
    expect_relative(*fit.r_squared, reference().value(name, "r_squared"), 1e-10, name);
  }
}

double sd_of(const std::vector<double>& sample) {
  const double n = static_cast<double>(sample.size());
  const double mean = std::accumulate(sample.begin(), sample.end(), 0.0) / n;
  double squares = 0.0;
  for (double x : sample) {
    squares += (x - mean) * (x - mean);
  }
  return std::sqrt(squares / (n - 1.0));
}

// B = 200,000 here and in SciPy, with different generators.  A limit is the p-quantile of
// the replicates, whose error is sqrt[p (1 - p) / B] / f(p); f is taken from the normal
// density, phi(z_p) / se.  p itself moves with z0, whose error is sqrt(1/4B) / phi(0) =
// 0.0028, doubled in z_p and stretched by the acceleration, at most 1 / (1 - 4 a).  For
// two independent runs and 4 standard errors
//     4 sqrt 2 se sqrt[p (1 - p) / (B phi(z_p)^2) + (2 * 0.0028 / (1 - 4 a))^2].
// A skewed tail stretches the replicates against the normal density: by at most 2 here
// (limits against the normal's, in reference_scipy.csv).  The shift from percentile to
// BCa is 2 to 4 times that tolerance, so that the one does not pass for the other.
TEST(StatisticsReference, BcaAgreesWithSciPyWithinMonteCarloError) {
  const ReferenceTable scipy("reference_scipy.csv");
  for (const std::string name : {"mean_skewed", "sd_skewed"}) {
    const std::vector<double> sample = scipy.values(name, "sample");
    BootstrapOptions options;
    options.resamples = 200000;
    const BootstrapIntervals found = name == "mean_skewed"
                                         ? bootstrap_mean(sample, options)
                                         : bootstrap(sample, sd_of, options);
    ASSERT_TRUE(found.bca && found.percentile && found.acceleration) << found.note;
    expect_relative(*found.estimate, scipy.value(name, "estimate"), kDigits, name);
    const double a = scipy.value(name, "acceleration");
    expect_relative(*found.acceleration, a, 1e-10, name);
    const double se = scipy.value(name, "standard_error");
    const auto tolerance = [&](double p, double of_z0) {
      const double z = normal_quantile(p);
      const double density = std::exp(-0.5 * z * z) / 2.5066282746310002;
      const double quantile = p * (1.0 - p) / (200000.0 * density * density);
      const double stretch = 2.0 * of_z0 / (1.0 - 4.0 * a);
      return 2.0 * 4.0 * std::sqrt(2.0) * se * std::sqrt(quantile + stretch * stretch);
    };
    const double low = scipy.value(name, "tail_low");
    const double high = scipy.value(name, "tail_high");
    EXPECT_NEAR(found.percentile->low, scipy.value(name, "percentile_low"),
                tolerance(0.025, 0.0));
    EXPECT_NEAR(found.percentile->high, scipy.value(name, "percentile_high"),
                tolerance(0.975, 0.0));
    EXPECT_NEAR(found.bca->low, scipy.value(name, "bca_low"), tolerance(low, 0.0028));
    EXPECT_NEAR(found.bca->high, scipy.value(name, "bca_high"), tolerance(high, 0.0028));
    EXPECT_GT(std::abs(found.bca->high - found.percentile->high),
              tolerance(high, 0.0028));
  }
}

}  // namespace
}  // namespace colloid::statistics
