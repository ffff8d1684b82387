#include "statistics/kaplan_meier.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/proportion.h"
#include "statistics/quantile.h"

namespace colloid::statistics {

namespace {

void check(const std::vector<Observation>& observations) {
  for (const Observation& seen : observations) {
    if (!std::isfinite(seen.time) || seen.time < 0.0) {
      throw InvalidSample("time to event: is " + std::to_string(seen.time) +
                          ", must be finite and not negative");
    }
  }
}

Interval complement(const Interval& of_events) {
  return {1.0 - of_events.high, 1.0 - of_events.low};
}

Interval log_log(double survival, double greenwood, double z) {
  const double theta = std::exp(z * std::sqrt(greenwood) / std::log(survival));
  return {std::pow(survival, 1.0 / theta), std::pow(survival, theta)};
}

/// The interval of `step`; `before` is the step before it, `censored_before` whether any
/// realisation left the risk set without an event until then.
Interval pointwise_interval(const SurvivalStep& step, const SurvivalStep* before,
                            std::size_t n, bool censored_before, double level) {
  if (step.survival == 1.0) {
    return complement(*clopper_pearson(0, step.at_risk, level).interval);
  }
  if (step.survival == 0.0) {
    if (censored_before && before != nullptr) {
      return {0.0, before->interval.high};
    }
    return complement(*clopper_pearson(n, n, level).interval);
  }
  return log_log(step.survival, step.greenwood, normal_factor(level));
}

}  // namespace

KaplanMeier kaplan_meier(std::vector<Observation> observations, double level) {
  require_level(level);
  check(observations);
  KaplanMeier curve;
  curve.n = observations.size();
  curve.level = level;
  curve.method =
      "Kaplan-Meier, log-log interval; Clopper-Pearson where none or all had the event";
  std::sort(observations.begin(), observations.end(),
            [](const Observation& a, const Observation& b) { return a.time < b.time; });
  SurvivalStep step;
  step.at_risk = curve.n;
  if (!observations.empty() && observations.front().time > 0.0) {
    step.interval = pointwise_interval(step, nullptr, curve.n, false, level);
    curve.steps.push_back(step);
  }
  std::size_t next = 0;
  while (next < curve.n) {
    step.time = observations[next].time;
    step.at_risk = curve.n - next;
    step.events = 0;
    const bool censored_before = curve.n_events < next;
    while (next < curve.n && observations[next].time == step.time) {
      step.events += observations[next].event ? 1u : 0u;
      ++next;
    }
    step.censored = step.at_risk - step.events - (curve.n - next);
    curve.n_events += step.events;
    const double risk = static_cast<double>(step.at_risk);
    const double died = static_cast<double>(step.events);
    step.survival *= (risk - died) / risk;
    step.greenwood += step.events == 0 ? 0.0
                      : step.events == step.at_risk
                          ? std::numeric_limits<double>::infinity()
                          : died / (risk * (risk - died));
    step.interval =
        pointwise_interval(step, curve.steps.empty() ? nullptr : &curve.steps.back(),
                           curve.n, censored_before, level);
    curve.steps.push_back(step);
  }
  return curve;
}

const SurvivalStep* step_at(const KaplanMeier& curve, double time) {
  const auto after =
      std::upper_bound(curve.steps.begin(), curve.steps.end(), time,
                       [](double t, const SurvivalStep& step) { return t < step.time; });
  return after == curve.steps.begin() ? nullptr : &*(after - 1);
}

MedianTime median_time(const KaplanMeier& curve) {
  // S is a product of rounded ratios: a half may come out an ulp or so above.
  constexpr double kHalf = 0.5 + 1e-12;
  MedianTime median;
  median.n = curve.n;
  median.level = curve.level;
  median.method = "Kaplan-Meier, Brookmeyer-Crowley of the log-log interval";
  for (const SurvivalStep& step : curve.steps) {
    if (!median.low && step.interval.low <= kHalf) {
      median.low = step.time;
    }
    if (!median.estimate && step.survival <= kHalf) {
      median.estimate = step.time;
    }
    if (!median.high && step.interval.high <= kHalf) {
      median.high = step.time;
    }
  }
  return median;
}

}  // namespace colloid::statistics
