#include "statistics/mean_interval.h"

#include <cmath>

#include "statistics/quantile.h"

namespace colloid::statistics {

MeanInterval mean_interval(const std::vector<double>& sample, double level) {
  require_level(level);
  require_finite(sample, "sample");
  MeanInterval result;
  result.n = sample.size();
  result.level = level;
  result.method = "Student t";
  if (sample.empty()) {
    result.note = "no realisation";
    return result;
  }
  const double n = static_cast<double>(sample.size());
  double sum = 0.0;
  for (double x : sample) {
    sum += x;
  }
  const bool equal = all_equal(sample);
  const double mean = equal ? sample.front() : sum / n;
  result.mean = mean;
  if (sample.size() == 1) {
    result.note = "one realisation has no spread and no interval";
    return result;
  }
  double squares = 0.0;
  for (double x : sample) {
    squares += (x - mean) * (x - mean);
  }
  const double sd = std::sqrt(squares / (n - 1.0));
  const double half = student_factor(level, n - 1.0) * sd / std::sqrt(n);
  result.sd = sd;
  result.interval = Interval{mean - half, mean + half};
  if (equal) {
    result.note = "all values are equal: the interval has no width";
  }
  return result;
}

}  // namespace colloid::statistics
