#include "statistics/censored_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "statistics/linear_fit.h"
#include "statistics/quantile.h"

namespace colloid::statistics {

namespace {

constexpr double kSqrtTwoPi = 2.5066282746310002;
constexpr double kFar = 25.0;  // beyond it erfc loses digits to underflow

/// phi(z) / Phi(-z), the inverse Mills ratio; far out by its asymptotic series.
double hazard(double z) {
  if (z < kFar) {
    return 2.0 * std::exp(-0.5 * z * z) / (kSqrtTwoPi * std::erfc(z / std::sqrt(2.0)));
  }
  const double s = 1.0 / (z * z);
  return z / (1.0 - s * (1.0 - 3.0 * s * (1.0 - 5.0 * s)));
}

double log_upper_tail(double z) {
  if (z < kFar) {
    return std::log(0.5 * std::erfc(z / std::sqrt(2.0)));
  }
  return -0.5 * z * z - std::log(kSqrtTwoPi * hazard(z));
}

/// x and y less a middle, over a spread: Newton then needs no care for units.
struct Scale {
  double x_middle = 0.0;
  double y_middle = 0.0;
  double x_spread = 1.0;
  double y_spread = 1.0;
};

/// Value, gradient and negative Hessian of ln L in (intercept, slope, 1) / sigma.
struct Likelihood {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

Likelihood likelihood(const std::vector<CensoredPoint>& points,
                      const Eigen::Vector3d& parameters) {
  const double theta = parameters[2];
  Likelihood sum;
  for (const CensoredPoint& point : points) {
    const Eigen::Vector3d v(-1.0, -point.x, point.y);  // of r by the parameters
    const double r = v.dot(parameters);
    if (point.censored) {
      const double h = hazard(r);
      sum.value += log_upper_tail(r);
      sum.gradient -= h * v;
      sum.information += h * (h - r) * v * v.transpose();
    } else {
      sum.value += std::log(theta / kSqrtTwoPi) - 0.5 * r * r;
      sum.gradient -= r * v;
      sum.gradient[2] += 1.0 / theta;
      sum.information += v * v.transpose();
      sum.information(2, 2) += 1.0 / (theta * theta);
    }
  }
  return sum;
}

/// The longest of the halved Newton steps that does not lower ln L.
Eigen::Vector3d searched_step(const std::vector<CensoredPoint>& points,
                              const Eigen::Vector3d& parameters,
                              const Eigen::Vector3d& newton, double value) {
  constexpr int kHalvings = 34;  // to 1e-10
  Eigen::Vector3d step = newton;
  for (int i = 0; i < kHalvings; ++i) {
    const Eigen::Vector3d trial = parameters + step;
    if (trial[2] > 0.0 && likelihood(points, trial).value >= value) {
      return step;
    }
    step *= 0.5;
  }
  return Eigen::Vector3d::Zero();
}

/// Newton's method; none if it does not converge.
std::optional<Eigen::Vector3d> maximise(const std::vector<CensoredPoint>& points,
                                        Eigen::Vector3d parameters) {
  constexpr int kIterations = 100;
  // Twice the gain of ln L that is left, by its quadratic model.  Below kNear full steps
  // converge, and ln L soon no longer resolves the gain that a search would look for.
  constexpr double kNear = 1e-6;
  constexpr double kConverged = 1e-20;
  for (int i = 0; i < kIterations; ++i) {
    const Likelihood here = likelihood(points, parameters);
    const Eigen::Vector3d newton = here.information.ldlt().solve(here.gradient);
    const double decrement = newton.dot(here.gradient);
    if (!std::isfinite(decrement)) {
      return std::nullopt;
    }
    if (decrement < kConverged) {
      return parameters;
    }
    parameters += decrement < kNear
                      ? newton
                      : searched_step(points, parameters, newton, here.value);
  }
  return std::nullopt;
}

/// Estimates and their covariance from the scaled parameters, in the user's units.
void fill(const std::vector<CensoredPoint>& points, const Eigen::Vector3d& parameters,
          const Scale& scale, CensoredFit& fit) {
  const Likelihood there = likelihood(points, parameters);
  const double theta = parameters[2];
  Eigen::Matrix<double, 2, 3> to_line;  // of (intercept, slope) by the parameters
  to_line << 1.0 / theta, 0.0, -parameters[0] / (theta * theta),  //
      0.0, 1.0 / theta, -parameters[1] / (theta * theta);
  const double ratio = scale.y_spread / scale.x_spread;
  Eigen::Matrix2d unscale;
  unscale << scale.y_spread, -ratio * scale.x_middle,  //
      0.0, ratio;
  const Eigen::Matrix<double, 2, 3> jacobian = unscale * to_line;
  const Eigen::Matrix2d covariance =
      jacobian * there.information.ldlt().solve(jacobian.transpose());
  const Eigen::Vector2d line = unscale * parameters.head<2>() / theta;
  const double z = normal_factor(fit.level);
  const double intercept = line[0] + scale.y_middle;
  const double slope = line[1];
  const double intercept_error = std::sqrt(covariance(0, 0));
  const double slope_error = std::sqrt(covariance(1, 1));
  fit.intercept = intercept;
  fit.slope = slope;
  fit.sigma = scale.y_spread / theta;
  fit.intercept_error = intercept_error;
  fit.slope_error = slope_error;
  fit.intercept_interval =
      Interval{intercept - z * intercept_error, intercept + z * intercept_error};
  fit.slope_interval = Interval{slope - z * slope_error, slope + z * slope_error};
  fit.log_likelihood = there.value - static_cast<double>(fit.n - fit.n_censored) *
                                         std::log(scale.y_spread);
}

}  // namespace

CensoredFit censored_fit(const std::vector<CensoredPoint>& points, double level) {
  CensoredFit fit;
  fit.n = points.size();
  fit.level = level;
  fit.method = "normal right-censored regression by maximum likelihood, Wald";
  std::vector<double> x;
  std::vector<double> y;
  x.reserve(points.size());
  y.reserve(points.size());
  for (const CensoredPoint& point : points) {
    require_finite({point.x, point.y}, "point of the censored fit");
    if (point.censored) {
      ++fit.n_censored;
    } else {
      x.push_back(point.x);
      y.push_back(point.y);
    }
  }
  const LinearFit observed = linear_fit(x, y, level);
  if (!observed.residual_sd) {
    fit.note = "fewer than three observed points, or all at one x";
    return fit;
  }
  const auto [x_low, x_high] = std::minmax_element(x.begin(), x.end());
  const auto [y_low, y_high] = std::minmax_element(y.begin(), y.end());
  Scale scale;
  scale.x_middle = 0.5 * (*x_low + *x_high);
  scale.x_spread = *x_high - *x_low;
  scale.y_middle = *observed.intercept + *observed.slope * scale.x_middle;
  scale.y_spread = *observed.residual_sd;
  if (!(scale.y_spread > 1e-12 * std::max(std::abs(*y_low), std::abs(*y_high)))) {
    fit.note = "the observed points lie on one line: sigma is not determined";
    return fit;
  }
  std::vector<CensoredPoint> scaled = points;
  for (CensoredPoint& point : scaled) {
    point.x = (point.x - scale.x_middle) / scale.x_spread;
    point.y = (point.y - scale.y_middle) / scale.y_spread;
  }
  const double slope = *observed.slope * scale.x_spread / scale.y_spread;
  const auto parameters = maximise(scaled, Eigen::Vector3d(0.0, slope, 1.0));
  if (!parameters) {
    fit.note = "the likelihood has no maximum that Newton's method finds";
    return fit;
  }
  fill(scaled, *parameters, scale, fit);
  return fit;
}

}  // namespace colloid::statistics
