#include "statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/quantile.h"
#include "statistics/resampler.h"

namespace colloid::statistics {

namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (double x : values) {
    sum += x;
  }
  return sum / static_cast<double>(values.size());
}

/// Share of the ascending replicates below the estimate, ties counting half.
double share_below(const std::vector<double>& ascending, double estimate) {
  const auto ties = std::equal_range(ascending.begin(), ascending.end(), estimate);
  const double twice = static_cast<double>((ties.first - ascending.begin()) +
                                           (ties.second - ascending.begin()));
  return 0.5 * twice / static_cast<double>(ascending.size());
}

std::optional<double> acceleration_of(const std::vector<double>& jackknife) {
  const double centre = mean_of(jackknife);
  double squares = 0.0;
  double cubes = 0.0;
  for (double value : jackknife) {
    const double d = centre - value;
    squares += d * d;
    cubes += d * d * d;
  }
  if (!(squares > 0.0)) {
    return std::nullopt;
  }
  return cubes / (6.0 * std::pow(squares, 1.5));
}

/// The adjusted tail of Efron's (2.3); none where the adjustment has its pole.
std::optional<double> adjusted_tail(double z0, double a, double z) {
  const double denominator = 1.0 - a * (z0 + z);
  if (!(denominator > 0.0)) {
    return std::nullopt;
  }
  return normal_cdf(z0 + (z0 + z) / denominator);
}

}  // namespace

BootstrapIntervals bootstrap_intervals(double estimate, std::vector<double> replicates,
                                       const std::vector<double>& jackknife,
                                       double level) {
  require_level(level);
  require_finite(replicates, "bootstrap replicates");
  BootstrapIntervals result;
  result.n = jackknife.size();
  result.resamples = replicates.size();
  result.level = level;
  result.estimate = estimate;
  std::sort(replicates.begin(), replicates.end());
  if (replicates.empty() || replicates.front() == replicates.back()) {
    result.note = "degenerate bootstrap: all replicates are equal";
    return result;
  }
  const double tail = 0.5 * (1.0 - level);
  result.percentile = Interval{sample_quantile(replicates, tail),
                               sample_quantile(replicates, 1.0 - tail)};

  const double below = share_below(replicates, estimate);
  if (below <= 0.0 || below >= 1.0) {
    result.note = "BCa undefined: all replicates lie on one side of the estimate";
    return result;
  }
  result.bias_correction = normal_quantile(below);
  result.acceleration = acceleration_of(jackknife);
  if (!result.acceleration) {
    result.note = "BCa undefined: all jackknife values are equal";
    return result;
  }
  const double z = normal_factor(level);
  const auto low = adjusted_tail(*result.bias_correction, *result.acceleration, -z);
  const auto high = adjusted_tail(*result.bias_correction, *result.acceleration, z);
  if (!low || !high) {
    result.note = "BCa undefined: the acceleration is too large";
    return result;
  }
  result.bca =
      Interval{sample_quantile(replicates, *low), sample_quantile(replicates, *high)};
  return result;
}

namespace {

BootstrapIntervals too_few(const std::vector<double>& sample, double level) {
  BootstrapIntervals result;
  result.n = sample.size();
  result.level = level;
  result.note = "fewer than two realisations";
  return result;
}

std::vector<double> replicates_of(const std::vector<double>& sample,
                                  const Statistic& statistic,
                                  const BootstrapOptions& options) {
  std::vector<double> replicates;
  replicates.reserve(options.resamples);
  std::vector<double> drawn;
  drawn.reserve(sample.size());
  Resampler resampler(sample.size(), options.seed);
  for (std::size_t b = 0; b < options.resamples; ++b) {
    const std::vector<std::uint32_t>& counts = resampler.draw();
    drawn.clear();
    for (std::size_t i = 0; i < sample.size(); ++i) {
      drawn.insert(drawn.end(), counts[i], sample[i]);
    }
    replicates.push_back(statistic(drawn));
  }
  return replicates;
}

}  // namespace

BootstrapIntervals bootstrap(const std::vector<double>& sample,
                             const Statistic& statistic,
                             const BootstrapOptions& options) {
  require_level(options.level);
  require_finite(sample, "sample");
  if (sample.size() < 2) {
    return too_few(sample, options.level);
  }
  std::vector<double> jackknife;
  jackknife.reserve(sample.size());
  for (std::size_t left_out = 0; left_out < sample.size(); ++left_out) {
    std::vector<double> rest = sample;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
    jackknife.push_back(statistic(rest));
  }
  return bootstrap_intervals(statistic(sample), replicates_of(sample, statistic, options),
                             jackknife, options.level);
}

BootstrapIntervals bootstrap_mean(const std::vector<double>& sample,
                                  const BootstrapOptions& options) {
  require_level(options.level);
  require_finite(sample, "sample");
  if (sample.size() < 2) {
    return too_few(sample, options.level);
  }
  // From the first value on, so that of equal values every replicate is exactly theirs.
  const double n = static_cast<double>(sample.size());
  const double origin = sample.front();
  const auto mean_with = [&](const std::vector<std::uint32_t>& counts) {
    double sum = 0.0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      sum += counts[i] * (sample[i] - origin);
    }
    return origin + sum / n;
  };
  std::vector<double> replicates;
  replicates.reserve(options.resamples);
  Resampler resampler(sample.size(), options.seed);
  for (std::size_t b = 0; b < options.resamples; ++b) {
    replicates.push_back(mean_with(resampler.draw()));
  }
  const double mean = mean_with(std::vector<std::uint32_t>(sample.size(), 1u));
  std::vector<double> jackknife;
  jackknife.reserve(sample.size());
  for (double x : sample) {
    jackknife.push_back(mean + (mean - x) / (n - 1.0));
  }
  return bootstrap_intervals(mean, std::move(replicates), jackknife, options.level);
}

}  // namespace colloid::statistics
