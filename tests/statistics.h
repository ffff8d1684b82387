// Tests of random draws whose rate of false alarms is known: at most kFalseAlarm for a
// seed that was not looked at before.  Seeds are fixed, so a test that passes keeps
// passing.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

namespace colloid {

constexpr double kFalseAlarm = 1e-6;

/// Kolmogorov & Smirnov: the largest distance between the distribution of `draws` and
/// `cumulative` stays below sqrt(ln(2/p)/(2n)) but with probability p, for every n
/// (Massart 1990, Ann. Probab. 18, 1269).
inline void expect_distributed(std::vector<double> draws,
                               const std::function<double(double)>& cumulative) {
  std::sort(draws.begin(), draws.end());
  const auto n = static_cast<double>(draws.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const double p = cumulative(draws[i]);
    const auto below = static_cast<double>(i);
    distance = std::max({distance, p - below / n, (below + 1.0) / n - p});
  }
  EXPECT_LT(distance, std::sqrt(std::log(2.0 / kFalseAlarm) / (2.0 * n)));
}

/// A value that a chi-squared variable of so many degrees of freedom is between, but with
/// probability kFalseAlarm.
inline void expect_chi_squared(double value, double degrees) {
  const boost::math::chi_squared distribution(degrees);
  EXPECT_GT(value, boost::math::quantile(distribution, 0.5 * kFalseAlarm));
  EXPECT_LT(value, boost::math::quantile(
                       boost::math::complement(distribution, 0.5 * kFalseAlarm)));
}

/// Pearson: all bins are equally likely.  Wants ten counts a bin or more.
inline void expect_equal_chances(const std::vector<int>& counts) {
  double total = 0.0;
  for (const int count : counts) {
    total += count;
  }
  const double expected = total / static_cast<double>(counts.size());
  ASSERT_GE(expected, 10.0);
  double chi2 = 0.0;
  for (const int count : counts) {
    chi2 += (count - expected) * (count - expected) / expected;
  }
  expect_chi_squared(chi2, static_cast<double>(counts.size()) - 1.0);
}

/// The bin of u in [0, 1) among `bins` equal ones.
inline std::size_t bin_of(double u, int bins) {
  return static_cast<std::size_t>(u * bins);
}

}  // namespace colloid
