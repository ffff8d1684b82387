// What every estimator here returns beside its number, and how it refuses bad samples.
//
// A number that the sample does not determine is std::nullopt, never zero or NaN; the
// note beside it says why.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace colloid::statistics {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// A sample or an option that no estimator can use: NaN, unequal lengths, a level outside
/// (0, 1).
class InvalidSample : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Refuses NaN and infinities; `name` says in the message which numbers these are.
void require_finite(const std::vector<double>& sample, const std::string& name);

/// Compared bit by bit: a spread of equal values computed from their mean may be
/// round-off.
bool all_equal(const std::vector<double>& sample);

void require_level(double level);

}  // namespace colloid::statistics
