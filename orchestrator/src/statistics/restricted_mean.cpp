#include "statistics/restricted_mean.h"

#include <algorithm>
#include <cmath>

#include "statistics/proportion.h"
#include "statistics/quantile.h"

namespace colloid::statistics {

namespace {

/// Steps at or before tau.
std::size_t steps_until(const KaplanMeier& curve, double tau) {
  std::size_t count = 0;
  while (count < curve.steps.size() && curve.steps[count].time <= tau) {
    ++count;
  }
  return count;
}

/// Area under S up to tau, and the variance of it, summed from tau backwards.
struct Area {
  double area = 0.0;
  double variance = 0.0;
};

Area integrate(const KaplanMeier& curve, double tau, std::size_t count) {
  Area result;
  double right = tau;
  for (std::size_t i = count; i-- > 0;) {
    const SurvivalStep& step = curve.steps[i];
    result.area += step.survival * (right - step.time);
    right = step.time;
    if (step.events > 0 && step.events < step.at_risk) {
      const double risk = static_cast<double>(step.at_risk);
      const double died = static_cast<double>(step.events);
      result.variance += result.area * result.area * died / (risk * (risk - died));
    }
  }
  result.area += right;  // S = 1 before the first step
  return result;
}

}  // namespace

RestrictedMean restricted_mean(const KaplanMeier& curve, double tau) {
  if (!std::isfinite(tau) || !(tau > 0.0)) {
    throw InvalidSample("tau: is " + std::to_string(tau) + ", must be above 0");
  }
  RestrictedMean result;
  result.n = curve.n;
  result.level = curve.level;
  result.tau = tau;
  result.method = "area under Kaplan-Meier up to tau, normal interval";
  if (curve.n == 0) {
    result.note = "no realisation";
    return result;
  }
  const SurvivalStep& last = curve.steps.back();
  if (last.time < tau && last.survival > 0.0) {
    result.note = "no realisation was followed to tau: survival is not known there";
    return result;
  }
  const std::size_t count = steps_until(curve, tau);
  const Area found = integrate(curve, tau, count);
  result.mean = found.area;
  if (curve.steps[count - 1].survival == 1.0) {
    // Those who left before tau say nothing about tau.
    const bool step_there = curve.steps[count - 1].time == tau;
    const SurvivalStep& there = curve.steps[step_there ? count - 1 : count];
    const double bound = clopper_pearson(0, there.at_risk, curve.level).interval->high;
    result.interval = Interval{tau * (1.0 - bound), tau};
    result.method = "no event by tau: Clopper-Pearson bound of survival times tau";
    return result;
  }
  if (found.variance == 0.0) {
    result.note = "all events came at one time: no variance and no interval";
    return result;
  }
  const double error = std::sqrt(found.variance);
  const double half = normal_factor(curve.level) * error;
  result.standard_error = error;
  result.interval =
      Interval{std::max(0.0, found.area - half), std::min(tau, found.area + half)};
  return result;
}

}  // namespace colloid::statistics
