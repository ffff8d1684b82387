// Nonlinear least squares of y = amplitude exp(rate x).
#pragma once

#include <optional>
#include <vector>

namespace colloid::statistics {

struct ExponentialCurve {
  double amplitude = 0.0;
  double rate = 0.0;  ///< in one over the unit of x
};

/// Straight line through (x, ln y) where y > 0; none with fewer than two such x.
std::optional<ExponentialCurve> log_linear_start(const std::vector<double>& x,
                                                 const std::vector<double>& y);

/// Minimises sum (y - amplitude exp(rate x))^2 from `start` by the method of Levenberg
/// (1944) and Marquardt (1963, SIAM J. 11, 431).  None if it does not converge: a rate
/// that runs away (all of y in one point) has no minimum.
std::optional<ExponentialCurve> fit_exponential_curve(const std::vector<double>& x,
                                                      const std::vector<double>& y,
                                                      const ExponentialCurve& start);

/// sum (y - amplitude exp(rate x))^2.
double sum_of_squares(const std::vector<double>& x, const std::vector<double>& y,
                      const ExponentialCurve& curve);

}  // namespace colloid::statistics
