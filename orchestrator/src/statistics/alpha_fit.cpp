#include "statistics/alpha_fit.h"

namespace colloid::statistics {

AlphaFit alpha_fit(const std::vector<const RealisationOutcome*>& outcomes, double level) {
  AlphaFit fit;
  std::vector<double> alpha;
  std::vector<double> duration;
  std::vector<CensoredPoint> all;
  alpha.reserve(outcomes.size());
  duration.reserve(outcomes.size());
  all.reserve(outcomes.size());
  fit.points.reserve(outcomes.size());
  for (const RealisationOutcome* outcome : outcomes) {
    if (!outcome->t1 || !outcome->alpha_deg) {
      continue;
    }
    AlphaPoint point;
    point.index = outcome->index;
    point.alpha_deg = *outcome->alpha_deg;
    point.duration = outcome->tc.value_or(outcome->end) - *outcome->t1;
    point.censored = !outcome->tc.has_value();
    point.diameter_lost = outcome->diameter_lost;
    fit.points.push_back(point);
    all.push_back({point.alpha_deg, point.duration, point.censored});
    if (!point.censored) {
      alpha.push_back(point.alpha_deg);
      duration.push_back(point.duration);
    }
  }
  fit.line = linear_fit(alpha, duration, level);
  fit.n_excluded = outcomes.size() - alpha.size();
  if (all.size() > alpha.size()) {
    fit.with_censored = censored_fit(all, level);
  }
  return fit;
}

}  // namespace colloid::statistics
