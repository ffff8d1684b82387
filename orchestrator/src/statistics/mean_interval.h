// Mean, standard deviation and Student's t-interval of independent realisations.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.h"

namespace colloid::statistics {

struct MeanInterval {
  std::size_t n = 0;
  double level = 0.0;
  std::optional<double> mean;
  std::optional<double> sd;  ///< s, with n - 1
  std::optional<Interval> interval;
  std::string method;
  std::string note;  ///< why a number is missing or degenerate; empty if nothing is
};

/// x +- t_{n-1} s / sqrt n.  One realisation has a mean and no interval; none has
/// nothing.
MeanInterval mean_interval(const std::vector<double>& sample, double level);

}  // namespace colloid::statistics
