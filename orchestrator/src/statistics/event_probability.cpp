#include "statistics/event_probability.h"

#include "statistics/proportion.h"

namespace colloid::statistics {

EventProbability event_probability(const std::vector<Observation>& observations,
                                   double time, double level) {
  const KaplanMeier curve = kaplan_meier(observations, level);
  EventProbability result;
  result.n = curve.n;
  result.level = level;
  result.time = time;
  if (curve.n == 0) {
    result.note = "no realisation";
    return result;
  }
  std::size_t events = 0;
  std::size_t followed = 0;  // known to have had no event by `time`
  for (const Observation& seen : observations) {
    if (seen.event && seen.time <= time) {
      ++events;
    } else if (seen.time >= time) {
      ++followed;
    }
  }
  if (events + followed == curve.n || (events == 0 && followed > 0)) {
    // Without events, those who left earlier say nothing about the time they did not
    // reach.
    const Proportion share = clopper_pearson(events, events + followed, level);
    result.estimate = share.estimate;
    result.interval = share.interval;
    result.method = share.method;
    return result;
  }
  const SurvivalStep* step = step_at(curve, time);
  if (step == nullptr || (followed == 0 && step->survival > 0.0)) {
    result.note = "no realisation was followed until then: survival is not known there";
    return result;
  }
  result.estimate = 1.0 - step->survival;
  result.interval = Interval{1.0 - step->interval.high, 1.0 - step->interval.low};
  result.method = "Kaplan-Meier, log-log interval";
  return result;
}

}  // namespace colloid::statistics
