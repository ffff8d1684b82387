#include "statistics/quantile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace colloid::statistics {

double normal_cdf(double z) {
  return boost::math::cdf(boost::math::normal(), z);
}

double normal_quantile(double p) {
  return boost::math::quantile(boost::math::normal(), p);
}

double normal_factor(double level) {
  return boost::math::quantile(
      boost::math::complement(boost::math::normal(), 0.5 * (1.0 - level)));
}

double student_factor(double level, double degrees) {
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(degrees), 0.5 * (1.0 - level)));
}

double student_equivalent(double z, double degrees) {
  constexpr double kUnderflow = 37.0;  // Phi(-z) is a normal number up to here
  const double tail = normal_cdf(-std::clamp(z, -kUnderflow, kUnderflow));
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(degrees), tail));
}

double beta_quantile(double p, double a, double b) {
  return boost::math::quantile(boost::math::beta_distribution<>(a, b), p);
}

double sample_quantile(const std::vector<double>& ascending, double p) {
  assert(!ascending.empty() && p >= 0.0 && p <= 1.0);
  const double position = p * static_cast<double>(ascending.size() - 1);
  const std::size_t below = static_cast<std::size_t>(std::floor(position));
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double weight = position - static_cast<double>(below);
  return ascending[below] + weight * (ascending[above] - ascending[below]);
}

}  // namespace colloid::statistics
