#include "statistics/exponential_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "statistics/linear_fit.h"

namespace colloid::statistics {

namespace {

/// Normal equations of (amplitude, rate) at one point of the iteration.
struct NormalEquations {
  double squares = 0.0;  ///< sum of squared residuals
  double aa = 0.0, ab = 0.0, bb = 0.0;
  double a = 0.0, b = 0.0;  ///< J' r
};

NormalEquations normal_equations(const std::vector<double>& x,
                                 const std::vector<double>& y,
                                 const ExponentialCurve& curve) {
  NormalEquations sums;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double by_amplitude = std::exp(curve.rate * x[i]);
    const double by_rate = curve.amplitude * x[i] * by_amplitude;
    const double residual = y[i] - curve.amplitude * by_amplitude;
    sums.squares += residual * residual;
    sums.aa += by_amplitude * by_amplitude;
    sums.ab += by_amplitude * by_rate;
    sums.bb += by_rate * by_rate;
    sums.a += by_amplitude * residual;
    sums.b += by_rate * residual;
  }
  return sums;
}

/// The cosine between the residuals and each column of J: zero at the minimum, whatever
/// the units.
bool orthogonal(const NormalEquations& n, double tolerance) {
  const double r = std::sqrt(n.squares);
  return std::abs(n.a) <= tolerance * std::sqrt(n.aa) * r &&
         std::abs(n.b) <= tolerance * std::sqrt(n.bb) * r;
}

/// The minimum for x in [0, 1].
std::optional<ExponentialCurve> minimise(const std::vector<double>& x,
                                         const std::vector<double>& y,
                                         ExponentialCurve curve) {
  constexpr int kIterations = 200;
  constexpr double kSteepest =
      200.0;  // exp(200 x): all in one point of any sensible grid
  constexpr double kCosine = 1e-9;
  double of_data = 0.0;
  for (double value : y) {
    of_data += value * value;
  }
  double damping = 1e-3;
  NormalEquations here = normal_equations(x, y, curve);
  for (int i = 0; i < kIterations; ++i) {
    if (orthogonal(here, kCosine) || here.squares <= 1e-28 * of_data) {
      return curve;
    }
    const double aa = here.aa * (1.0 + damping);
    const double bb = here.bb * (1.0 + damping);
    const double determinant = aa * bb - here.ab * here.ab;
    const ExponentialCurve trial{
        curve.amplitude + (bb * here.a - here.ab * here.b) / determinant,
        curve.rate + (aa * here.b - here.ab * here.a) / determinant};
    if (!(std::abs(trial.rate) < kSteepest) || !std::isfinite(trial.amplitude)) {
      damping *= 10.0;
    } else {
      const NormalEquations there = normal_equations(x, y, trial);
      if (there.squares < here.squares) {
        curve = trial;
        here = there;
        damping = std::max(damping * 0.1, 1e-12);
      } else {
        damping *= 10.0;
      }
    }
    if (damping > 1e12) {
      // The sum of squares no longer resolves a step; its minimum is as flat as this.
      return orthogonal(here, 1e-6) ? std::optional(curve) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<ExponentialCurve> log_linear_start(const std::vector<double>& x,
                                                 const std::vector<double>& y) {
  assert(x.size() == y.size());
  std::vector<double> where;
  std::vector<double> logarithm;
  where.reserve(x.size());
  logarithm.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (y[i] > 0.0) {
      where.push_back(x[i]);
      logarithm.push_back(std::log(y[i]));
    }
  }
  const LinearFit line = linear_fit(where, logarithm, 0.95);
  if (!line.slope) {
    return std::nullopt;
  }
  return ExponentialCurve{std::exp(*line.intercept), *line.slope};
}

std::optional<ExponentialCurve> fit_exponential_curve(const std::vector<double>& x,
                                                      const std::vector<double>& y,
                                                      const ExponentialCurve& start) {
  assert(x.size() == y.size() && !x.empty());
  // x to [0, 1] from its lowest value, so that no exponential overflows on the way.
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double origin = *low;
  const double length = *high - origin;
  if (!(length > 0.0)) {
    return std::nullopt;
  }
  std::vector<double> scaled;
  scaled.reserve(x.size());
  for (double value : x) {
    scaled.push_back((value - origin) / length);
  }
  const auto found = minimise(
      scaled, y, {start.amplitude * std::exp(start.rate * origin), start.rate * length});
  if (!found) {
    return std::nullopt;
  }
  const double rate = found->rate / length;
  return ExponentialCurve{found->amplitude * std::exp(-rate * origin), rate};
}

double sum_of_squares(const std::vector<double>& x, const std::vector<double>& y,
                      const ExponentialCurve& curve) {
  return normal_equations(x, y, curve).squares;
}

}  // namespace colloid::statistics
