#include "statistics/mean_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "statistics/quantile.h"
#include "statistics/resampler.h"

namespace colloid::statistics {

namespace {

using Curves = std::vector<std::vector<double>>;

void check(const Curves& curves) {
  for (const std::vector<double>& curve : curves) {
    require_finite(curve, "curve");
    if (curve.size() != curves.front().size()) {
      throw InvalidSample("mean curve: curves of " + std::to_string(curve.size()) +
                          " and " + std::to_string(curves.front().size()) + " points");
    }
  }
}

std::vector<double> mean_of(const Curves& curves) {
  std::vector<double> mean(curves.front().size(), 0.0);
  for (const std::vector<double>& curve : curves) {
    for (std::size_t j = 0; j < mean.size(); ++j) {
      mean[j] += curve[j];
    }
  }
  for (double& value : mean) {
    value /= static_cast<double>(curves.size());
  }
  return mean;
}

std::vector<double> deviation_of(const Curves& curves, const std::vector<double>& mean) {
  std::vector<double> squares(mean.size(), 0.0);
  for (const std::vector<double>& curve : curves) {
    for (std::size_t j = 0; j < mean.size(); ++j) {
      squares[j] += (curve[j] - mean[j]) * (curve[j] - mean[j]);
    }
  }
  for (double& value : squares) {
    value = std::sqrt(value / static_cast<double>(curves.size() - 1));
  }
  return squares;
}

/// c_B.  Points where all curves agree (t = 0) have no spread and cannot be exceeded.
double bootstrap_factor(const Curves& curves, const std::vector<double>& mean,
                        const std::vector<double>& sd, const BootstrapOptions& options) {
  const double n = static_cast<double>(curves.size());
  Resampler resampler(curves.size(), options.seed);
  std::vector<double> largest;
  largest.reserve(options.resamples);
  std::vector<double> shift(mean.size());
  for (std::size_t b = 0; b < options.resamples; ++b) {
    const std::vector<std::uint32_t>& counts = resampler.draw();
    std::fill(shift.begin(), shift.end(), 0.0);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      // Deviations of the counts from one add up to the shift of the mean.
      const double excess = static_cast<double>(counts[i]) - 1.0;
      if (excess != 0.0) {
        for (std::size_t j = 0; j < shift.size(); ++j) {
          shift[j] += excess * curves[i][j];
        }
      }
    }
    double most = 0.0;
    for (std::size_t j = 0; j < shift.size(); ++j) {
      if (sd[j] > 0.0) {
        most = std::max(most, std::abs(shift[j]) / (sd[j] * std::sqrt(n)));
      }
    }
    largest.push_back(most);
  }
  std::sort(largest.begin(), largest.end());
  return sample_quantile(largest, options.level);
}

std::vector<Interval> around(const std::vector<double>& mean,
                             const std::vector<double>& sd, double factor, double n) {
  std::vector<Interval> intervals;
  intervals.reserve(mean.size());
  for (std::size_t j = 0; j < mean.size(); ++j) {
    const double half = factor * sd[j] / std::sqrt(n);
    intervals.push_back({mean[j] - half, mean[j] + half});
  }
  return intervals;
}

}  // namespace

std::vector<double> on_grid(const StepSeries& series, const std::vector<double>& grid,
                            bool hold_last) {
  require_finite(series.time, "time of a series");
  require_finite(series.value, "value of a series");
  if (series.time.size() != series.value.size() || series.time.empty() ||
      !std::is_sorted(series.time.begin(), series.time.end())) {
    throw InvalidSample("series: times must ascend, one per value, at least one");
  }
  std::vector<double> values;
  values.reserve(grid.size());
  for (double t : grid) {
    if (t < series.time.front() || (t > series.time.back() && !hold_last)) {
      throw InvalidSample("series: covers " + std::to_string(series.time.front()) +
                          " to " + std::to_string(series.time.back()) +
                          " s, but the grid asks for " + std::to_string(t) + " s");
    }
    const auto after = std::upper_bound(series.time.begin(), series.time.end(), t);
    values.push_back(
        series.value[static_cast<std::size_t>(after - series.time.begin()) - 1]);
  }
  return values;
}

std::vector<double> uniform_grid(double end, std::size_t points) {
  if (!(end > 0.0) || !std::isfinite(end) || points < 2) {
    throw InvalidSample("grid: needs an end above 0 and at least two points");
  }
  std::vector<double> grid;
  grid.reserve(points);
  for (std::size_t j = 0; j < points; ++j) {
    grid.push_back(end * static_cast<double>(j) / static_cast<double>(points - 1));
  }
  return grid;
}

MeanCurve mean_curve(const Curves& curves, const BootstrapOptions& options) {
  require_level(options.level);
  check(curves);
  MeanCurve result;
  result.n = curves.size();
  result.level = options.level;
  result.interval_method = "pointwise Student t";
  result.band_method = "simultaneous, bootstrap of the largest standardised deviation";
  if (curves.empty()) {
    result.note = "no realisation";
    return result;
  }
  result.mean = mean_of(curves);
  if (curves.size() == 1) {
    result.note = "one realisation has no spread and no interval";
    return result;
  }
  const double n = static_cast<double>(curves.size());
  result.sd = deviation_of(curves, result.mean);
  const double pointwise = student_factor(options.level, n - 1.0);
  const double of_bootstrap = bootstrap_factor(curves, result.mean, result.sd, options) *
                              std::sqrt(n / (n - 1.0));
  // A few realisations or resamples may give less than a single point needs: a band is
  // never narrower than the pointwise interval.
  const double simultaneous =
      std::max(pointwise, student_equivalent(of_bootstrap, n - 1.0));
  result.resamples = options.resamples;
  result.pointwise_factor = pointwise;
  result.simultaneous_factor = simultaneous;
  result.interval = around(result.mean, result.sd, pointwise, n);
  result.band = around(result.mean, result.sd, simultaneous, n);
  return result;
}

}  // namespace colloid::statistics
