#include "statistics/prefix.h"

#include <algorithm>
#include <string>

namespace colloid::statistics {

namespace {

Observation time_to(const std::optional<double>& event, double end) {
  return event ? Observation{*event, true} : Observation{end, false};
}

}  // namespace

Prefix complete_prefix(const std::vector<RealisationOutcome>& outcomes) {
  std::vector<const RealisationOutcome*> ordered;
  ordered.reserve(outcomes.size());
  for (const RealisationOutcome& outcome : outcomes) {
    ordered.push_back(&outcome);
  }
  std::sort(ordered.begin(), ordered.end(),
            [](const RealisationOutcome* a, const RealisationOutcome* b) {
              return a->index < b->index;
            });
  Prefix prefix;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const RealisationOutcome& outcome = *ordered[i];
    if (i > 0 && ordered[i - 1]->index == outcome.index) {
      throw InvalidSample("realisation " + std::to_string(outcome.index) +
                          " is there twice");
    }
    if (outcome.progress == Progress::failed) {
      ++prefix.n_failed;
    } else if (outcome.progress == Progress::finished) {
      prefix.finished.push_back(&outcome);
    } else {
      break;
    }
  }
  return prefix;
}

Observation clogging(const RealisationOutcome& outcome) {
  return time_to(outcome.tc, outcome.end);
}

Observation first_retention(const RealisationOutcome& outcome) {
  return time_to(outcome.t1, outcome.end);
}

std::vector<Observation> clogging_of_all_started(
    const std::vector<RealisationOutcome>& outcomes) {
  std::vector<Observation> observations;
  observations.reserve(outcomes.size());
  for (const RealisationOutcome& outcome : outcomes) {
    if (outcome.progress == Progress::finished || outcome.progress == Progress::running) {
      observations.push_back(clogging(outcome));
    }
  }
  return observations;
}

}  // namespace colloid::statistics
