// Straight line through right-censored values by maximum likelihood (Tobit-type).
//
//     y_i = intercept + slope x_i + sigma e_i,  e_i standard normal,
//
// of which a censored y_i is known only to exceed the value given:
//
//     ln L = sum_observed ln[phi(r_i) / sigma] + sum_censored ln Phi(-r_i),
//     r_i = (y_i - intercept - slope x_i) / sigma
//
// In 1/sigma and the coefficients over sigma ln L is concave (Olsen 1978, Econometrica
// 46, 1211), so Newton's method finds the one maximum.  Intervals are Wald's, from the
// observed information: too narrow for a few realisations, as sigma is taken as known.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.h"

namespace colloid::statistics {

struct CensoredPoint {
  double x = 0.0;
  double y = 0.0;  ///< the value, or the bound that it exceeds
  bool censored = false;
};

struct CensoredFit {
  std::size_t n = 0;
  std::size_t n_censored = 0;
  double level = 0.0;
  std::optional<double> slope;
  std::optional<double> intercept;
  std::optional<double> sigma;
  std::optional<double> slope_error;
  std::optional<double> intercept_error;
  std::optional<Interval> slope_interval;
  std::optional<Interval> intercept_interval;
  std::optional<double> log_likelihood;
  std::string method;
  std::string note;  ///< why there is no fit
};

/// Needs three observed points that lie neither on one x nor exactly on one line.
CensoredFit censored_fit(const std::vector<CensoredPoint>& points, double level);

}  // namespace colloid::statistics
