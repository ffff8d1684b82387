#include "statistics/prefix.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace colloid::statistics {

namespace {

Observation time_to(const std::optional<double>& event, double end) {
  return event ? Observation{*event, true} : Observation{end, false};
}

std::vector<const RealisationOutcome*> in_seed_order(
    const std::vector<RealisationOutcome>& outcomes) {
  std::vector<const RealisationOutcome*> ordered;
  ordered.reserve(outcomes.size());
  for (const RealisationOutcome& outcome : outcomes) {
    ordered.push_back(&outcome);
  }
  std::sort(ordered.begin(), ordered.end(),
            [](const RealisationOutcome* a, const RealisationOutcome* b) {
              return a->index < b->index;
            });
  for (std::size_t i = 1; i < ordered.size(); ++i) {
    if (ordered[i - 1]->index == ordered[i]->index) {
      throw InvalidSample("realisation " + std::to_string(ordered[i]->index) +
                          " is there twice");
    }
  }
  return ordered;
}

}  // namespace

Prefix complete_prefix(const std::vector<RealisationOutcome>& outcomes) {
  Prefix prefix;
  for (const RealisationOutcome* outcome : in_seed_order(outcomes)) {
    if (outcome->progress == Progress::failed) {
      ++prefix.n_failed;
    } else if (outcome->progress == Progress::finished) {
      prefix.finished.push_back(outcome);
    } else {
      break;
    }
  }
  return prefix;
}

Observation clogging(const RealisationOutcome& outcome) {
  return time_to(outcome.tc, outcome.end);
}

void snap_to(std::vector<Observation>& observations, double tau) {
  for (Observation& seen : observations) {
    if (std::abs(seen.time - tau) <= 1e-9 * tau) {
      seen.time = tau;
    }
  }
}

Observation first_retention(const RealisationOutcome& outcome) {
  return time_to(outcome.t1, outcome.end);
}

std::vector<const RealisationOutcome*> all_started(
    const std::vector<RealisationOutcome>& outcomes) {
  std::vector<const RealisationOutcome*> started;
  started.reserve(outcomes.size());
  for (const RealisationOutcome* outcome : in_seed_order(outcomes)) {
    if (outcome->progress == Progress::finished ||
        outcome->progress == Progress::running) {
      started.push_back(outcome);
    }
  }
  return started;
}

}  // namespace colloid::statistics
