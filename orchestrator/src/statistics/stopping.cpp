#include "statistics/stopping.h"

#include <cmath>

#include "statistics/interval.h"

namespace colloid::statistics {

StoppingDecision decide_stopping(
    const StoppingRule& rule, std::size_t available,
    const std::function<std::optional<double>(std::size_t)>& half_width_of_first) {
  constexpr std::size_t kSmallestPilot = 20;
  if (!(rule.half_width > 0.0) || !std::isfinite(rule.half_width)) {
    throw InvalidSample("stopping: the half-width asked for must exceed 0");
  }
  if (rule.pilot < kSmallestPilot || rule.batch == 0) {
    throw InvalidSample("stopping: pilot is " + std::to_string(rule.pilot) +
                        " and batch " + std::to_string(rule.batch) +
                        ", must be at least 20 and 1");
  }
  StoppingDecision decision;
  decision.note = "decided in sequence: the confidence level is approximate";
  for (std::size_t n = rule.pilot; n <= available; n += rule.batch) {
    ++decision.looks;
    decision.half_width = half_width_of_first(n);
    if (decision.half_width && *decision.half_width > 0.0 &&
        *decision.half_width <= rule.half_width) {
      decision.stop_at = n;
      break;
    }
  }
  return decision;
}

}  // namespace colloid::statistics
