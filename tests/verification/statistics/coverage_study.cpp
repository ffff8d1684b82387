#include "coverage_study.h"

#include <algorithm>
#include <cmath>

#include "statistics/bootstrap.h"
#include "statistics/censored_fit.h"
#include "statistics/exponential_fit.h"
#include "statistics/kaplan_meier.h"
#include "statistics/mean_curve.h"
#include "statistics/mean_interval.h"
#include "statistics/restricted_mean.h"

namespace colloid::statistics {

namespace {

constexpr double kLevel = 0.95;

class Tally {
 public:
  explicit Tally(std::size_t samples) : samples_(samples) {}
  void add(bool covered) { hits_ += covered ? 1u : 0u; }
  Coverage coverage() const {
    return {static_cast<double>(hits_) / static_cast<double>(samples_), samples_};
  }

 private:
  std::size_t samples_;
  std::size_t hits_ = 0;
};

bool holds(const Interval& interval, double truth) {
  return interval.low <= truth && truth <= interval.high;
}

BootstrapOptions bootstrap_options(std::size_t resamples, std::size_t sample) {
  BootstrapOptions options;
  options.resamples = resamples;
  options.level = kLevel;
  options.seed = 1000 + sample;
  return options;
}

}  // namespace

double Coverage::standard_error() const {
  return std::sqrt(0.95 * 0.05 / static_cast<double>(samples));
}

Coverage student_of_normal(std::size_t n, std::size_t samples) {
  Draws draws(11);
  Tally tally(samples);
  std::vector<double> sample(n);
  for (std::size_t i = 0; i < samples; ++i) {
    for (double& x : sample) {
      x = 3.0 + 2.0 * draws.normal();
    }
    tally.add(holds(*mean_interval(sample, kLevel).interval, 3.0));
  }
  return tally.coverage();
}

Coverage student_of_exponential(std::size_t n, std::size_t samples) {
  Draws draws(12);
  Tally tally(samples);
  std::vector<double> sample(n);
  for (std::size_t i = 0; i < samples; ++i) {
    for (double& x : sample) {
      x = draws.exponential(1.0);
    }
    tally.add(holds(*mean_interval(sample, kLevel).interval, 1.0));
  }
  return tally.coverage();
}

// The distribution is that of coverage.R: time to clogging 0.2 + exponential of mean 1.2,
// deadline 2, one in five leaves at a uniform time before it.
SurvivalCoverage survival(std::size_t n, std::size_t samples) {
  const double true_survival = std::exp(-0.8 / 1.2);
  const double true_median = 0.2 + 1.2 * std::log(2.0);
  const double true_mean = 0.2 + 1.2 * (1.0 - std::exp(-1.8 / 1.2));
  Draws draws(13);
  Tally of_survival(samples);
  Tally of_median(samples);
  Tally of_mean(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    std::vector<Observation> observations;
    observations.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double time = 0.2 + draws.exponential(1.2);
      const double left = draws.uniform() < 0.2 ? 2.0 * draws.uniform() : 2.0;
      observations.push_back({std::min(time, left), time <= left});
    }
    const KaplanMeier curve = kaplan_meier(observations, kLevel);
    of_survival.add(holds(step_at(curve, 1.0)->interval, true_survival));
    const MedianTime median = median_time(curve);
    of_median.add(median.low.value_or(0.0) <= true_median &&
                  true_median <= median.high.value_or(HUGE_VAL));
    const RestrictedMean mean = restricted_mean(curve, 2.0);
    of_mean.add(mean.interval && holds(*mean.interval, true_mean));
  }
  return {of_survival.coverage(), of_median.coverage(), of_mean.coverage()};
}

BootstrapCoverage bootstrap_of_exponential(std::size_t n, std::size_t samples) {
  Draws draws(14);
  Tally percentile(samples);
  Tally bca(samples);
  std::vector<double> sample(n);
  for (std::size_t i = 0; i < samples; ++i) {
    for (double& x : sample) {
      x = draws.exponential(1.0);
    }
    const BootstrapIntervals found = bootstrap_mean(sample, bootstrap_options(1000, i));
    percentile.add(found.percentile && holds(*found.percentile, 1.0));
    bca.add(found.bca && holds(*found.bca, 1.0));
  }
  return {percentile.coverage(), bca.coverage()};
}

// Curves that start alike and spread: 1 - t plus a random walk of normal steps, at 25
// times.
BandCoverage band(std::size_t n, std::size_t samples) {
  constexpr std::size_t kPoints = 25;
  Draws draws(15);
  Tally pointwise(samples);
  Tally simultaneous(samples);
  Tally all_pointwise(samples);
  std::vector<std::vector<double>> curves(n, std::vector<double>(kPoints));
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::vector<double>& curve : curves) {
      double walk = 0.0;
      for (std::size_t j = 0; j < kPoints; ++j) {
        curve[j] = 1.0 - static_cast<double>(j) / kPoints + walk;
        walk += 0.1 * draws.normal();
      }
    }
    const MeanCurve found = mean_curve(curves, bootstrap_options(500, i));
    bool inside_band = true;
    bool inside_all = true;
    bool inside = true;
    for (std::size_t j = 1; j < kPoints; ++j) {  // at j = 0 all curves are 1
      const double truth = 1.0 - static_cast<double>(j) / kPoints;
      inside_band = inside_band && holds(found.band[j], truth);
      inside = holds(found.interval[j], truth);
      inside_all = inside_all && inside;
    }
    pointwise.add(inside);
    simultaneous.add(inside_band);
    all_pointwise.add(inside_all);
  }
  return {pointwise.coverage(), simultaneous.coverage(), all_pointwise.coverage()};
}

// One injection per realisation into 14 annuli of 3 um, with probabilities that are
// exactly exponential: A exp(-x / 15 um), adding up to one.
ExponentialCoverage exponential_profile(std::size_t n, std::size_t samples) {
  constexpr std::size_t kAnnuli = 14;
  constexpr double kRate = -1.0 / 15e-6;
  std::vector<double> centre;
  double total = 0.0;
  for (std::size_t j = 0; j < kAnnuli; ++j) {
    centre.push_back((static_cast<double>(j) + 0.5) * 3e-6);
    total += std::exp(kRate * centre.back());
  }
  const double amplitude = 1.0 / total;
  Draws draws(16);
  Tally of_amplitude(samples);
  Tally of_rate(samples);
  ExponentialCoverage coverage;
  for (std::size_t i = 0; i < samples; ++i) {
    std::vector<std::vector<double>> rows(n, std::vector<double>(kAnnuli, 0.0));
    for (std::vector<double>& row : rows) {
      double left = draws.uniform();
      std::size_t j = 0;
      while (j + 1 < kAnnuli && left > amplitude * std::exp(kRate * centre[j])) {
        left -= amplitude * std::exp(kRate * centre[j]);
        ++j;
      }
      row[j] = 1.0;
    }
    const ExponentialFit fit = exponential_fit(centre, rows, bootstrap_options(400, i));
    coverage.without_interval += fit.rate_interval ? 0u : 1u;
    of_amplitude.add(fit.amplitude_interval && holds(*fit.amplitude_interval, amplitude));
    of_rate.add(fit.rate_interval && holds(*fit.rate_interval, kRate));
  }
  coverage.amplitude = of_amplitude.coverage();
  coverage.rate = of_rate.coverage();
  return coverage;
}

// The model of coverage.R: y = 2.5 - 0.02 x + 0.8 e with x uniform on (-40, 80), known
// only to exceed 3 where it does.
Coverage censored_slope(std::size_t n, std::size_t samples) {
  Draws draws(17);
  Tally tally(samples);
  std::vector<CensoredPoint> points(n);
  for (std::size_t i = 0; i < samples; ++i) {
    for (CensoredPoint& point : points) {
      point.x = -40.0 + 120.0 * draws.uniform();
      const double y = 2.5 - 0.02 * point.x + 0.8 * draws.normal();
      point.y = std::min(y, 3.0);
      point.censored = y > 3.0;
    }
    const CensoredFit fit = censored_fit(points, kLevel);
    tally.add(fit.slope_interval && holds(*fit.slope_interval, -0.02));
  }
  return tally.coverage();
}

}  // namespace colloid::statistics
