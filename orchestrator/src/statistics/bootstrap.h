// Bootstrap intervals: percentile, and bias-corrected and accelerated (BCa).
//
// With replicates th*_1 .. th*_B of an estimate th, and jackknife values th_(i),
//
//     z0 = Phi^-1{ [#(th* < th) + #(th* <= th)] / 2B }
//     a  = sum d_i^3 / [6 (sum d_i^2)^(3/2)],    d_i = mean of th_(.) - th_(i)
//     p  = Phi{ z0 + (z0 + z) / [1 - a (z0 + z)] },    z = -+ Phi^-1((1 + level) / 2)
//
// and the limits are the p-quantiles of the replicates.
// Source: Efron 1987, JASA 82, 171, eqs (2.3), (4.1), (6.6); ties count half.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.h"

namespace colloid::statistics {

struct BootstrapOptions {
  std::size_t resamples = 2000;  ///< B
  double level = 0.95;
  std::uint64_t seed = 1;
};

struct BootstrapIntervals {
  std::size_t n = 0;
  std::size_t resamples = 0;
  double level = 0.0;
  std::optional<double> estimate;
  std::optional<Interval> percentile;
  std::optional<Interval> bca;
  std::optional<double> bias_correction;  ///< z0
  std::optional<double> acceleration;     ///< a
  std::string note;                       ///< why an interval is missing
};

using Statistic = std::function<double(const std::vector<double>&)>;

/// Resamples the sample and applies `statistic`, which must not depend on the order and
/// is called for samples of one value less too (n + 1 + resamples calls).
/// A sample of fewer than two values, or one whose replicates are all equal, has no
/// interval.
BootstrapIntervals bootstrap(const std::vector<double>& sample,
                             const Statistic& statistic, const BootstrapOptions& options);

/// The same of the mean, in time proportional to n (1 + resamples).
BootstrapIntervals bootstrap_mean(const std::vector<double>& sample,
                                  const BootstrapOptions& options);

/// Both intervals from replicates and jackknife values made elsewhere.
BootstrapIntervals bootstrap_intervals(double estimate, std::vector<double> replicates,
                                       const std::vector<double>& jackknife,
                                       double level);

}  // namespace colloid::statistics
