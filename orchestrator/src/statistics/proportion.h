// Intervals of a proportion: k of n realisations.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "statistics/interval.h"

namespace colloid::statistics {

struct Proportion {
  std::size_t n = 0;
  std::size_t k = 0;
  double level = 0.0;
  std::optional<double> estimate;  ///< k / n; none if n = 0
  std::optional<Interval> interval;
  std::string method;
};

/// Exact: inverts the two one-sided binomial tests (Clopper & Pearson 1934, Biometrika
/// 26, 404), so it covers with at least `level` for every n.
Proportion clopper_pearson(std::size_t k, std::size_t n, double level);

/// Inverts the score test (Wilson 1927, JASA 22, 209): covers with `level` on average
/// over proportions and is shorter.
Proportion wilson(std::size_t k, std::size_t n, double level);

}  // namespace colloid::statistics
