#include "report/target_watch.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/scene_facts.h"
#include "statistics/stopping.h"
#include "statistics/target.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using statistics::Progress;
using statistics::RealisationOutcome;

std::optional<double> optional_real(const Statement& row, int column) {
  return row.is_null(column) ? std::nullopt : std::optional(row.real(column));
}

/// The first `n` realisations of an ensemble; none if one of them has not ended.
std::optional<std::vector<RealisationOutcome>> first_of(const Database& database,
                                                        const Plan& plan,
                                                        const Ensemble& ensemble, int n) {
  Statement rows = database.prepare(
      "SELECT r.idx, r.status, r.duration_s, r.t1_s, r.tc_s FROM realisation r "
      "JOIN ensemble e ON e.id = r.ensemble JOIN point p ON p.id = e.point "
      "JOIN campaign c ON c.id = p.campaign WHERE c.name = ? AND p.number = ? "
      "AND e.tier = ? AND r.idx < ? AND r.status IN ('ingested', 'failed') "
      "ORDER BY r.idx");
  rows.bind(1, plan.campaign).bind(2, ensemble.point).bind(3, ensemble.tier).bind(4, n);
  std::vector<RealisationOutcome> outcomes;
  while (rows.step()) {
    RealisationOutcome outcome;
    outcome.index = static_cast<std::uint64_t>(rows.integer(0));
    outcome.progress = rows.text(1) == "ingested" ? Progress::finished : Progress::failed;
    outcome.t1 = optional_real(rows, 3);
    outcome.tc = optional_real(rows, 4);
    outcome.end = std::max({rows.is_null(2) ? 0.0 : rows.real(2),
                            outcome.t1.value_or(0.0), outcome.tc.value_or(0.0)});
    outcomes.push_back(std::move(outcome));
  }
  return outcomes.size() == static_cast<std::size_t>(n) ? std::optional(outcomes)
                                                        : std::nullopt;
}

}  // namespace

TargetWatch::TargetWatch(const Plan& plan, const Database& database)
    : plan_(plan),
      target_(target_of(plan.statistics, plan.realisations)),
      states_(plan.ensembles.size()) {
  if (target_) {
    for (TargetState& state : states_) {
      state.next_look = target_->pilot;
    }
    look(database);
  }
}

std::optional<int> TargetWatch::look(const Database& database) {
  std::optional<int> first;
  for (std::size_t e = 0; target_ && e < states_.size(); ++e) {
    const int before = wanted(e);
    look(database, e);
    if (wanted(e) > before) {
      first = std::min(first.value_or(before), before);
    }
  }
  return first;
}

void TargetWatch::look(const Database& database, std::size_t ensemble) {
  TargetState& state = states_[ensemble];
  const std::optional<double> tau = scene_facts(plan_.ensembles[ensemble].scene).duration;
  const double level = plan_.statistics.value("confidence", 0.95);
  while (state.next_look > 0) {
    const int n = state.next_look;
    const auto outcomes = first_of(database, plan_, plan_.ensembles[ensemble], n);
    if (!outcomes) {
      return;
    }
    const auto size = static_cast<std::size_t>(n);
    const statistics::StoppingDecision decision = statistics::decide_stopping(
        {target_->half_width, size, 1}, size, [&](std::size_t) {
          return statistics::half_width_of(target_->statistic, *outcomes, tau, level);
        });
    ++state.looks;
    state.seen = n;
    state.half_width = decision.half_width;
    state.met = decision.stop_at.has_value();
    state.next_look = state.met || n == plan_.realisations
                          ? 0
                          : n + std::min(target_->batch, plan_.realisations - n);
  }
}

int TargetWatch::wanted(std::size_t ensemble) const {
  if (!target_) {
    return plan_.realisations;
  }
  const TargetState& state = states_[ensemble];
  return state.next_look > 0 ? state.next_look : state.seen;
}

bool TargetWatch::is_missed() const {
  return target_ &&
         std::all_of(states_.begin(), states_.end(),
                     [](const TargetState& s) { return s.next_look == 0; }) &&
         std::any_of(states_.begin(), states_.end(),
                     [](const TargetState& s) { return !s.met; });
}

Json TargetWatch::json(std::size_t ensemble) const {
  if (!target_) {
    return nullptr;
  }
  const TargetState& state = states_[ensemble];
  return {{"statistic", target_->statistic},
          {"unit", unit_of(*target_)},
          {"half_width_asked", target_->half_width},
          {"half_width", state.half_width ? Json(*state.half_width) : Json()},
          {"met", state.met},
          {"n", state.seen},
          {"looks", state.looks},
          {"next_look", state.next_look > 0 ? Json(state.next_look) : Json()},
          {"pilot", target_->pilot},
          {"batch", target_->batch},
          {"most", plan_.realisations},
          {"method",
           "Chow & Robbins 1965, looked at in seed order; the level of the "
           "interval is approximate"},
          {"text", text(ensemble)}};
}

std::string TargetWatch::text(std::size_t ensemble) const {
  if (!target_) {
    return "";
  }
  const TargetState& state = states_[ensemble];
  const std::string unit = unit_of(*target_).empty() ? "" : " " + unit_of(*target_);
  std::string out = fmt::format("target: {}; ", aim_of(*target_));
  if (state.looks == 0) {
    return out + fmt::format("first decided after {} realisations", state.next_look);
  }
  const std::string now = state.half_width
                              ? fmt::format("{:.3g}{}", *state.half_width, unit)
                              : std::string("not determined");
  out += fmt::format("after {} realisations it is {}: ", state.seen, now);
  if (state.met) {
    return out + "met";
  }
  return out +
         (state.next_look > 0
              ? fmt::format("decided again after {}", state.next_look)
              : fmt::format("NOT met; `poreclog extend {}` goes on", plan_.campaign));
}

}  // namespace colloid
