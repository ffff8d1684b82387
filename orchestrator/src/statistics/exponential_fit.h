// Exponential through the ensemble mean of a profile, with intervals over realisations.
//
// The points of one profile are correlated (the annuli of one injection position exclude
// each other), so s^2 (J'J)^-1 of the least-squares problem is not their covariance.  The
// intervals therefore resample whole realisations: each resample is averaged and fitted
// anew.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/bootstrap.h"
#include "statistics/interval.h"

namespace colloid::statistics {

struct ExponentialFit {
  std::size_t n = 0;         ///< realisations
  std::size_t n_points = 0;  ///< of the profile
  std::size_t resamples = 0;
  std::size_t failed_resamples = 0;  ///< whose fit has no minimum
  double level = 0.0;
  std::optional<double> amplitude;
  std::optional<double> rate;
  std::optional<double> r_squared;  ///< 1 - SSE / SST in the original scale
  std::optional<Interval> amplitude_interval;
  std::optional<Interval> rate_interval;
  std::string method;
  std::string note;  ///< why a number is missing
};

/// Fits amplitude exp(rate x) to the mean over `rows`, [realisation][point] at x[point].
/// Needs three points, two of them positive; intervals need two realisations and a
/// minimum in all but one per cent of the resamples.
ExponentialFit exponential_fit(const std::vector<double>& x,
                               const std::vector<std::vector<double>>& rows,
                               const BootstrapOptions& options);

}  // namespace colloid::statistics
