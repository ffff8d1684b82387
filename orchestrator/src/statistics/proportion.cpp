#include "statistics/proportion.h"

#include <algorithm>
#include <cmath>

#include "statistics/quantile.h"

namespace colloid::statistics {

namespace {

Proportion observed(std::size_t k, std::size_t n, double level) {
  require_level(level);
  if (k > n) {
    throw InvalidSample("proportion: " + std::to_string(k) + " of " + std::to_string(n));
  }
  Proportion result;
  result.n = n;
  result.k = k;
  result.level = level;
  if (n > 0) {
    result.estimate = static_cast<double>(k) / static_cast<double>(n);
  }
  return result;
}

}  // namespace

Proportion clopper_pearson(std::size_t k, std::size_t n, double level) {
  Proportion result = observed(k, n, level);
  result.method = "Clopper-Pearson";
  if (n > 0) {
    const double tail = 0.5 * (1.0 - level);
    const double hits = static_cast<double>(k);
    const double misses = static_cast<double>(n - k);
    result.interval =
        Interval{k == 0 ? 0.0 : beta_quantile(tail, hits, misses + 1.0),
                 k == n ? 1.0 : beta_quantile(1.0 - tail, hits + 1.0, misses)};
  }
  return result;
}

Proportion wilson(std::size_t k, std::size_t n, double level) {
  Proportion result = observed(k, n, level);
  result.method = "Wilson";
  if (n > 0) {
    const double z = normal_factor(level);
    const double trials = static_cast<double>(n);
    const double p = *result.estimate;
    const double shrink = 1.0 + z * z / trials;
    const double centre = (p + z * z / (2.0 * trials)) / shrink;
    const double half =
        z / shrink * std::sqrt(p * (1.0 - p) / trials + z * z / (4.0 * trials * trials));
    // At k = 0 and k = n the limit is 0 or 1 but for round-off.
    result.interval = Interval{k == 0 ? 0.0 : std::max(0.0, centre - half),
                               k == n ? 1.0 : std::min(1.0, centre + half)};
  }
  return result;
}

}  // namespace colloid::statistics
