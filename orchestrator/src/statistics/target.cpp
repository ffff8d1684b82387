#include "statistics/target.h"

#include <algorithm>
#include <cmath>

#include "statistics/event_probability.h"
#include "statistics/kaplan_meier.h"
#include "statistics/mean_interval.h"
#include "statistics/prefix.h"
#include "statistics/restricted_mean.h"

namespace colloid::statistics {

namespace {

std::optional<double> half(const std::optional<Interval>& interval) {
  return interval && std::isfinite(interval->low) && std::isfinite(interval->high)
             ? std::optional(0.5 * (interval->high - interval->low))
             : std::nullopt;
}

/// What one realisation has of the mean aimed at; none if it is censored.
std::optional<double> time_of(const std::string& name, const RealisationOutcome& o) {
  if (name == "t1") {
    return o.t1;
  }
  if (name == "tc") {
    return o.tc;
  }
  return o.tc && o.t1 ? std::optional(*o.tc - *o.t1) : std::nullopt;
}

std::optional<double> half_width_of_mean(
    const std::string& name, const std::vector<const RealisationOutcome*>& all,
    double level) {
  std::vector<double> sample;
  for (const RealisationOutcome* outcome : all) {
    const std::optional<double> time = time_of(name, *outcome);
    if (!time) {
      return std::nullopt;
    }
    sample.push_back(*time);
  }
  return half(mean_interval(sample, level).interval);
}

}  // namespace

const std::vector<std::string>& target_names() {
  static const std::vector<std::string> names{
      "t1", "tc", "tc_minus_t1", "median_s", "restricted_mean_s", "probability_by_end"};
  return names;
}

std::string unit_of_target(const std::string& name) {
  return name == "probability_by_end" ? "" : "s";
}

std::optional<double> half_width_of(const std::string& name,
                                    const std::vector<RealisationOutcome>& outcomes,
                                    const std::optional<double>& tau, double level) {
  const auto& names = target_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InvalidSample("stopping: there is no number " + name);
  }
  const std::vector<const RealisationOutcome*> finished =
      complete_prefix(outcomes).finished;
  if (finished.empty()) {
    return std::nullopt;
  }
  if (name == "t1" || name == "tc" || name == "tc_minus_t1") {
    return half_width_of_mean(name, finished, level);
  }
  std::vector<Observation> observations;
  observations.reserve(finished.size());
  for (const RealisationOutcome* outcome : finished) {
    observations.push_back(clogging(*outcome));
  }
  if (tau) {
    snap_to(observations, *tau);
  }
  const KaplanMeier curve = kaplan_meier(observations, level);
  if (name == "median_s") {
    const MedianTime median = median_time(curve);
    return median.low && median.high ? half(Interval{*median.low, *median.high})
                                     : std::nullopt;
  }
  if (!tau) {
    return std::nullopt;
  }
  return name == "restricted_mean_s"
             ? half(restricted_mean(curve, *tau).interval)
             : half(event_probability(observations, *tau, level).interval);
}

}  // namespace colloid::statistics
