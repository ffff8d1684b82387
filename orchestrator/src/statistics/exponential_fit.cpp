#include "statistics/exponential_fit.h"

#include <cstdint>
#include <map>
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

/// Profiles of realisations, of which there are only as many different ones as annuli:
/// the cost of a mean grows with n, not with n times their points.
class Profiles {
 public:
  explicit Profiles(const Rows& rows) : kind_(rows.size()) {
    std::map<std::vector<double>, std::size_t> known;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto [at, is_new] = known.emplace(rows[i], different_.size());
      if (is_new) {
        different_.push_back(rows[i]);
      }
      kind_[i] = at->second;
    }
  }

  std::size_t size() const { return kind_.size(); }
  std::size_t kinds() const { return different_.size(); }
  std::size_t kind(std::size_t i) const { return kind_[i]; }

  /// Mean with realisation i counted counts[i] times.
  std::vector<double> mean(const std::vector<std::uint32_t>& counts) const {
    std::vector<double> weights(different_.size(), 0.0);
    for (std::size_t i = 0; i < kind_.size(); ++i) {
      weights[kind_[i]] += counts[i];
    }
    std::vector<double> mean(different_.front().size(), 0.0);
    double total = 0.0;
    for (std::size_t k = 0; k < different_.size(); ++k) {
      total += weights[k];
      for (std::size_t j = 0; j < mean.size(); ++j) {
        mean[j] += weights[k] * different_[k][j];
      }
    }
    for (double& value : mean) {
      value /= total;
    }
    return mean;
  }

 private:
  Rows different_;
  std::vector<std::size_t> kind_;  ///< of each realisation, in different_
};

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

Refits resample(const std::vector<double>& x, const Profiles& rows,
                const ExponentialCurve& start, const BootstrapOptions& options) {
  Refits refits;
  refits.amplitude.reserve(options.resamples);
  refits.rate.reserve(options.resamples);
  Resampler resampler(rows.size(), options.seed);
  for (std::size_t b = 0; b < options.resamples; ++b) {
    const auto curve = fit_exponential_curve(x, rows.mean(resampler.draw()), start);
    if (curve) {
      refits.add(*curve);
    }
  }
  return refits;
}

/// Fits with one realisation left out in turn; empty if one of them has no minimum.
/// Realisations with equal profiles leave the same mean, which is fitted once.
Refits jackknife(const std::vector<double>& x, const Profiles& rows,
                 const ExponentialCurve& start) {
  Refits refits;
  std::vector<std::uint32_t> counts(rows.size(), 1u);
  std::vector<std::optional<ExponentialCurve>> fitted(rows.kinds());
  for (std::size_t left_out = 0; left_out < rows.size(); ++left_out) {
    std::optional<ExponentialCurve>& curve = fitted[rows.kind(left_out)];
    if (!curve) {
      counts[left_out] = 0;
      curve = fit_exponential_curve(x, rows.mean(counts), start);
      counts[left_out] = 1;
    }
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
  const Profiles profiles(rows);
  const std::vector<double> mean =
      profiles.mean(std::vector<std::uint32_t>(rows.size(), 1u));
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
  Refits refits = resample(x, profiles, *curve, options);
  fit.resamples = options.resamples;
  fit.failed_resamples = options.resamples - refits.rate.size();
  if (refits.rate.empty() || 100 * fit.failed_resamples > options.resamples) {
    fit.note = "too many resamples have no minimum: no interval";
    return fit;
  }
  const Refits left_out = jackknife(x, profiles, *curve);
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
