#include "statistics/linear_fit.h"

#include <cmath>

#include "statistics/quantile.h"

namespace colloid::statistics {

namespace {

struct Sums {
  double x_mean = 0.0;
  double y_mean = 0.0;
  double xx = 0.0;  ///< of squares about the mean
  double xy = 0.0;
  double yy = 0.0;
};

Sums sums_about_the_mean(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  Sums sums;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sums.x_mean += x[i] / n;
    sums.y_mean += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - sums.x_mean;
    const double dy = y[i] - sums.y_mean;
    sums.xx += dx * dx;
    sums.xy += dx * dy;
    sums.yy += dy * dy;
  }
  return sums;
}

}  // namespace

LinearFit linear_fit(const std::vector<double>& x, const std::vector<double>& y,
                     double level) {
  require_level(level);
  require_finite(x, "x");
  require_finite(y, "y");
  if (x.size() != y.size()) {
    throw InvalidSample("linear fit: x and y differ in length");
  }
  LinearFit fit;
  fit.n = x.size();
  fit.level = level;
  fit.method = "ordinary least squares, Student t";
  if (fit.n < 2 || all_equal(x)) {
    fit.note = fit.n < 2 ? "fewer than two points" : "all x are equal";
    return fit;
  }
  const Sums sums = sums_about_the_mean(x, y);
  const double slope = sums.xy / sums.xx;
  const double intercept = sums.y_mean - slope * sums.x_mean;
  double residuals = 0.0;
  for (std::size_t i = 0; i < fit.n; ++i) {
    const double e = (y[i] - sums.y_mean) - slope * (x[i] - sums.x_mean);
    residuals += e * e;
  }
  fit.slope = slope;
  fit.intercept = intercept;
  if (!all_equal(y)) {
    fit.r_squared = 1.0 - residuals / sums.yy;
  }
  if (fit.n == 2) {
    fit.note = "two points leave no degree of freedom for intervals";
    return fit;
  }
  const double n = static_cast<double>(fit.n);
  const double sd = std::sqrt(residuals / (n - 2.0));
  const double t = student_factor(level, n - 2.0);
  const double slope_error = sd / std::sqrt(sums.xx);
  const double intercept_error =
      sd * std::sqrt(1.0 / n + sums.x_mean * sums.x_mean / sums.xx);
  fit.residual_sd = sd;
  fit.slope_error = slope_error;
  fit.intercept_error = intercept_error;
  fit.slope_interval = Interval{slope - t * slope_error, slope + t * slope_error};
  fit.intercept_interval =
      Interval{intercept - t * intercept_error, intercept + t * intercept_error};
  return fit;
}

}  // namespace colloid::statistics
