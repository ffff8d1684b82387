// Ordinary least squares of a straight line, y = intercept + slope x.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.h"

namespace colloid::statistics {

struct LinearFit {
  std::size_t n = 0;
  double level = 0.0;
  std::optional<double> slope;
  std::optional<double> intercept;
  std::optional<double> slope_error;      ///< standard error
  std::optional<double> intercept_error;  ///< standard error
  std::optional<double> residual_sd;      ///< sqrt[SSE / (n - 2)]
  std::optional<Interval> slope_interval;
  std::optional<Interval> intercept_interval;
  std::optional<double> r_squared;  ///< 1 - SSE / SST; none if all y are equal
  std::string method;
  std::string note;  ///< why a number is missing
};

/// Intervals with t_{n-2}.  Needs two points with different x; intervals need three.
LinearFit linear_fit(const std::vector<double>& x, const std::vector<double>& y,
                     double level);

}  // namespace colloid::statistics
