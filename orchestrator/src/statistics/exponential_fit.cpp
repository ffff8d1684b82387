#include "statistics/exponential_fit.h"

#include <cstdint>
#include <utility>

#include "statistics/exponential_curve.h"
#include "statistics/resampler.h"

namespace colloid::statistics {

namespace {

using Rows = std::vector<std::vector<double>>;

void check(const std::vector<double>& x, const Rows& rows) {
  require_finite(x, "x");
  for (const std::vector<double>& row : rows) {
    require_finite(row, "profile");
    if (row.size() != x.size()) {
      throw InvalidSample("exponential fit: a profile of " + std::to_string(row.size()) +
                          " points on " + std::to_string(x.size()) + " places");
    }
  }
}

std::vector<double> weighted_mean(const Rows& rows,
                                  const std::vector<std::uint32_t>& counts) {
  std::vector<double> mean(rows.front().size(), 0.0);
  double total = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    total += counts[i];
    for (std::size_t j = 0; counts[i] > 0 && j < mean.size(); ++j) {
      mean[j] += counts[i] * rows[i][j];
    }
  }
  for (double& value : mean) {
    value /= total;
  }
  return mean;
}

std::optional<double> r_squared(const std::vector<double>& x,
                                const std::vector<double>& y,
                                const ExponentialCurve& curve) {
  double mean = 0.0;
  for (double value : y) {
    mean += value / static_cast<double>(y.size());
  }
  double total = 0.0;
  for (double value : y) {
    total += (value - mean) * (value - mean);
  }
  if (!(total > 0.0)) {
    return std::nullopt;
  }
  return 1.0 - sum_of_squares(x, y, curve) / total;
}

/// Amplitudes and rates of refits, in step.
struct Refits {
  std::vector<double> amplitude;
  std::vector<double> rate;

  void add(const ExponentialCurve& curve) {
    amplitude.push_back(curve.amplitude);
    rate.push_back(curve.rate);
  }
};

Refits resample(const std::vector<double>& x, const Rows& rows,
                const ExponentialCurve& start, const BootstrapOptions& options) {
  Refits refits;
  refits.amplitude.reserve(options.resamples);
  refits.rate.reserve(options.resamples);
  Resampler resampler(rows.size(), options.seed);
  for (std::size_t b = 0; b < options.resamples; ++b) {
    const auto curve =
        fit_exponential_curve(x, weighted_mean(rows, resampler.draw()), start);
    if (curve) {
      refits.add(*curve);
    }
  }
  return refits;
}

/// Fits with one realisation left out in turn; empty if one of them has no minimum.
Refits jackknife(const std::vector<double>& x, const Rows& rows,
                 const ExponentialCurve& start) {
  Refits refits;
  std::vector<std::uint32_t> counts(rows.size(), 1u);
  for (std::size_t left_out = 0; left_out < rows.size(); ++left_out) {
    counts[left_out] = 0;
    const auto curve = fit_exponential_curve(x, weighted_mean(rows, counts), start);
    counts[left_out] = 1;
    if (!curve) {
      return {};
    }
    refits.add(*curve);
  }
  return refits;
}

}  // namespace

ExponentialFit exponential_fit(const std::vector<double>& x, const Rows& rows,
                               const BootstrapOptions& options) {
  require_level(options.level);
  check(x, rows);
  ExponentialFit fit;
  fit.n = rows.size();
  fit.n_points = x.size();
  fit.level = options.level;
  fit.method =
      "nonlinear least squares (Levenberg-Marquardt), BCa interval over realisations";
  if (rows.empty() || x.size() < 3) {
    fit.note = rows.empty() ? "no realisation" : "fewer than three points";
    return fit;
  }
  const std::vector<double> mean =
      weighted_mean(rows, std::vector<std::uint32_t>(rows.size(), 1u));
  const auto start = log_linear_start(x, mean);
  if (!start) {
    fit.note = "fewer than two points are positive";
    return fit;
  }
  const auto curve = fit_exponential_curve(x, mean, *start);
  if (!curve) {
    fit.note = "least squares has no minimum at a finite rate";
    return fit;
  }
  fit.amplitude = curve->amplitude;
  fit.rate = curve->rate;
  fit.r_squared = r_squared(x, mean, *curve);
  if (rows.size() < 2) {
    fit.note = "one realisation has no interval";
    return fit;
  }
  Refits refits = resample(x, rows, *curve, options);
  fit.resamples = options.resamples;
  fit.failed_resamples = options.resamples - refits.rate.size();
  if (refits.rate.empty() || 100 * fit.failed_resamples > options.resamples) {
    fit.note = "too many resamples have no minimum: no interval";
    return fit;
  }
  const Refits left_out = jackknife(x, rows, *curve);
  if (left_out.rate.empty()) {
    fit.note = "BCa undefined: without one of the realisations there is no minimum";
    return fit;
  }
  const BootstrapIntervals of_amplitude = bootstrap_intervals(
      curve->amplitude, std::move(refits.amplitude), left_out.amplitude, options.level);
  const BootstrapIntervals of_rate = bootstrap_intervals(
      curve->rate, std::move(refits.rate), left_out.rate, options.level);
  fit.amplitude_interval = of_amplitude.bca;
  fit.rate_interval = of_rate.bca;
  fit.note = of_rate.note.empty() ? of_amplitude.note : of_rate.note;
  return fit;
}

}  // namespace colloid::statistics
