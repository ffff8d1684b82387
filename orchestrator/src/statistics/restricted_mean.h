// Restricted mean time mu(tau) = int_0^tau S dt: the mean of min(T, tau).
//
//     Var mu = sum_{t_i <= tau} [int_{t_i}^tau S dt]^2 d_i / [n_i (n_i - d_i)]
//
// Source: Klein & Moeschberger 2003, Survival Analysis, eqs (4.5.1), (4.5.2).  The
// interval is the normal one, cut to [0, tau].  If nobody had the event by tau the
// variance is 0; then mu >= tau S(tau) with the exact bound of S(tau) gives the interval.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "statistics/interval.h"
#include "statistics/kaplan_meier.h"

namespace colloid::statistics {

struct RestrictedMean {
  std::size_t n = 0;
  double level = 0.0;
  double tau = 0.0;  ///< [s], fixed before the data were seen
  std::optional<double> mean;
  std::optional<double> standard_error;
  std::optional<Interval> interval;
  std::string method;
  std::string note;  ///< why a number is missing
};

/// tau > 0.  No mean if the last realisation left before tau while S > 0: S is not known
/// from there on.
RestrictedMean restricted_mean(const KaplanMeier& curve, double tau);

}  // namespace colloid::statistics
