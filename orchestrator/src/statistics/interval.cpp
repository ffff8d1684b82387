#include "statistics/interval.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace colloid::statistics {

void require_finite(const std::vector<double>& sample, const std::string& name) {
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!std::isfinite(sample[i])) {
      throw InvalidSample(name + ": value " + std::to_string(i + 1) + " of " +
                          std::to_string(sample.size()) + " is " +
                          (std::isnan(sample[i]) ? "not a number" : "infinite") +
                          ", must be finite");
    }
  }
}

bool all_equal(const std::vector<double>& sample) {
  return std::adjacent_find(sample.begin(), sample.end(), std::not_equal_to<>()) ==
         sample.end();
}

void require_level(double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw InvalidSample("confidence: is " + std::to_string(level) +
                        ", must be above 0 and below 1");
  }
}

}  // namespace colloid::statistics
