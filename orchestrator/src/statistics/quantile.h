// Quantiles of the distributions that intervals are made of, and of a sample.
#pragma once

#include <vector>

namespace colloid::statistics {

/// Phi(z) of the standard normal distribution.
double normal_cdf(double z);

/// Phi^-1(p), 0 < p < 1.
double normal_quantile(double p);

/// Half-width in standard errors of a two-sided normal interval: Phi^-1((1 + level) / 2).
double normal_factor(double level);

/// The same of Student's t with `degrees` > 0 degrees of freedom.
double student_factor(double level, double degrees);

/// The value that Student's t exceeds as often as the standard normal exceeds z.
double student_equivalent(double z, double degrees);

/// p-quantile of the beta distribution with shapes a, b > 0.
double beta_quantile(double p, double a, double b);

/// p-quantile of an ascending sample, linear between order statistics: at position
/// (n - 1) p (type 7 of Hyndman & Fan 1996, Am. Stat. 50, 361; the default of R and
/// NumPy).
double sample_quantile(const std::vector<double>& ascending, double p);

}  // namespace colloid::statistics
