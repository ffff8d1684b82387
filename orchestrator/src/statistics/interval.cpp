#include "statistics/interval.h"

#include <cmath>
#include <cstddef>

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

void require_level(double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw InvalidSample("confidence: is " + std::to_string(level) +
                        ", must be above 0 and below 1");
  }
}

}  // namespace colloid::statistics
