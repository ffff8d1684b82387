// Probability that the event (clogging) has happened by a given time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.h"
#include "statistics/kaplan_meier.h"

namespace colloid::statistics {

struct EventProbability {
  std::size_t n = 0;
  double level = 0.0;
  double time = 0.0;  ///< [s]
  std::optional<double> estimate;
  std::optional<Interval> interval;
  std::string method;
  std::string note;  ///< why the number is missing
};

/// If nobody was censored before `time` the outcome is yes or no, and the interval is
/// Clopper & Pearson's; otherwise 1 - S(time) of Kaplan & Meier.
EventProbability event_probability(const std::vector<Observation>& observations,
                                   double time, double level);

}  // namespace colloid::statistics
