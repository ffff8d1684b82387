#include "statistics/stages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "statistics/interval.h"

namespace colloid::statistics {

namespace {

void check(const std::vector<double>& time, const std::vector<double>& values) {
  require_finite(time, "time of a curve");
  require_finite(values, "curve");
  const bool ascends =
      std::adjacent_find(time.begin(), time.end(), std::greater_equal<>()) == time.end();
  if (time.size() != values.size() || !ascends) {
    throw InvalidSample("curve: times must ascend strictly, one per value");
  }
}

}  // namespace

std::optional<double> first_fall_to(double threshold, const std::vector<double>& time,
                                    const std::vector<double>& curve) {
  check(time, curve);
  for (std::size_t j = 0; j < curve.size(); ++j) {
    if (curve[j] > threshold) {
      continue;
    }
    if (j == 0) {
      return time.front();
    }
    const double part = (curve[j - 1] - threshold) / (curve[j - 1] - curve[j]);
    return time[j - 1] + part * (time[j] - time[j - 1]);
  }
  return std::nullopt;
}

std::optional<double> settling_time(const std::vector<double>& time,
                                    const std::vector<double>& sd, double share) {
  check(time, sd);
  if (sd.size() < 2) {
    return std::nullopt;
  }
  std::vector<double> slope;
  slope.reserve(sd.size() - 1);
  for (std::size_t j = 0; j + 1 < sd.size(); ++j) {
    slope.push_back(std::abs((sd[j + 1] - sd[j]) / (time[j + 1] - time[j])));
  }
  const double steepest = *std::max_element(slope.begin(), slope.end());
  const std::size_t top =
      static_cast<std::size_t>(std::max_element(sd.begin(), sd.end()) - sd.begin());
  std::size_t settled = slope.size();
  while (settled > top && slope[settled - 1] < share * steepest) {
    --settled;
  }
  if (settled == slope.size()) {
    return std::nullopt;
  }
  return time[settled];
}

}  // namespace colloid::statistics
