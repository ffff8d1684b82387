#include "report/read_ensemble.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ingest/hdf5_file.h"

namespace colloid {

namespace {

using statistics::Progress;
using statistics::RealisationOutcome;

constexpr std::int64_t kOrders = 5;  // of retention, whose injection is looked at

std::optional<double> optional_real(const Statement& row, int column) {
  return row.is_null(column) ? std::nullopt : std::optional(row.real(column));
}

std::optional<double> unless_nan(const std::optional<double>& value) {
  return value && !std::isnan(*value) ? value : std::nullopt;
}

Progress progress_of(const std::string& status) {
  if (status == "ingested") {
    return Progress::finished;
  }
  if (status == "failed") {
    return Progress::failed;
  }
  return status == "eligible" ? Progress::pending : Progress::running;
}

/// How far a realisation has got that has not ended: from its last checkpoint.  False if
/// there is none.
bool read_checkpoint(const std::string& realisation, RealisationOutcome& outcome) {
  const auto file = open_hdf5(realisation + "/checkpoint.h5");
  const auto state = file ? open_group(file->get(), "realisation") : std::nullopt;
  const auto series = state ? open_group(state->get(), "series") : std::nullopt;
  const auto times = series ? numbers(series->get(), "time_s") : std::nullopt;
  if (!times || times->empty()) {
    return false;
  }
  outcome.end = times->back();
  const auto event = [&](const char* name) {
    const auto at = unless_nan(number_attribute(state->get(), name));
    // An event between the last row and the checkpoint has happened too.
    outcome.end = std::max(outcome.end, at.value_or(0.0));
    return at;
  };
  outcome.t1 = event("t1_s");
  outcome.tc = event("tc_s");
  outcome.progress = Progress::running;
  return true;
}

/// Reads the columns that hang on a realisation's id.
class Details {
 public:
  explicit Details(const Database& database)
      : changes_(database.prepare(
            "SELECT step, critical_diameter_m, permeability_ratio FROM series_change "
            "WHERE realisation = ? ORDER BY step")),
        times_(database.prepare(
            "SELECT time_s FROM grid_time WHERE grid = ? ORDER BY step")),
        injected_(database.prepare(
            "SELECT injection_x_m, injection_y_m FROM retained WHERE realisation = ? AND "
            "retention_order <= ? ORDER BY retention_order")) {}

  void read_injections(std::int64_t id, RealisationOutcome& outcome) {
    injected_.reset().bind(1, id).bind(2, kOrders);
    while (injected_.step() && !injected_.is_null(0) && !injected_.is_null(1)) {
      outcome.injection_positions.push_back({injected_.real(0), injected_.real(1)});
    }
  }

  void read_curves(std::int64_t id, std::int64_t grid, RealisationOutcome& outcome) {
    const std::vector<double>& times = times_of(grid);
    statistics::StepSeries diameter;
    statistics::StepSeries ratio;
    changes_.reset().bind(1, id);
    while (changes_.step()) {
      const auto step = static_cast<std::size_t>(changes_.integer(0));
      if (step >= times.size() || changes_.is_null(1) || changes_.is_null(2)) {
        return;  // not recorded: no curve
      }
      diameter.time.push_back(times[step]);
      diameter.value.push_back(changes_.real(1));
      ratio.value.push_back(changes_.real(2));
    }
    if (diameter.time.empty()) {
      return;
    }
    if (diameter.time.back() < times.back()) {  // nothing changed any more
      diameter.time.push_back(times.back());
      diameter.value.push_back(diameter.value.back());
      ratio.value.push_back(ratio.value.back());
    }
    ratio.time = diameter.time;
    if (outcome.t1) {
      const auto after =
          std::lower_bound(diameter.time.begin(), diameter.time.end(), *outcome.t1);
      if (after != diameter.time.end()) {
        outcome.diameter_lost =
            diameter.value.front() -
            diameter.value[static_cast<std::size_t>(after - diameter.time.begin())];
      }
    }
    outcome.critical_diameter = std::move(diameter);
    outcome.permeability_ratio = std::move(ratio);
  }

 private:
  const std::vector<double>& times_of(std::int64_t grid) {
    const auto known = grids_.find(grid);
    if (known != grids_.end()) {
      return known->second;
    }
    std::vector<double>& times = grids_[grid];
    times_.reset().bind(1, grid);
    while (times_.step()) {
      times.push_back(times_.real(0));
    }
    return times;
  }

  Statement changes_;
  Statement times_;
  Statement injected_;
  std::map<std::int64_t, std::vector<double>> grids_;
};

/// The ensemble's id, or -1.
std::int64_t id_of(const Database& database, const Plan& plan, const Ensemble& ensemble) {
  Statement find = database.prepare(
      "SELECT e.id FROM ensemble e JOIN point p ON p.id = e.point "
      "JOIN campaign c ON c.id = p.campaign "
      "WHERE c.name = ? AND p.number = ? AND e.tier = ?");
  find.bind(1, plan.campaign).bind(2, ensemble.point).bind(3, ensemble.tier);
  return find.step() ? find.integer(0) : -1;
}

std::size_t prefix_length(const std::vector<RealisationOutcome>& outcomes) {
  std::size_t n = 0;
  while (n < outcomes.size() && (outcomes[n].progress == Progress::finished ||
                                 outcomes[n].progress == Progress::failed)) {
    ++n;
  }
  return n;
}

/// Decides how an unfinished ensemble is looked at.  `all_known`: of every realisation
/// that has started it is known how far it has got.
void settle_interim(EnsembleSample& sample, bool all_known) {
  const std::size_t prefix = prefix_length(sample.outcomes);
  for (std::size_t i = prefix; i < sample.outcomes.size(); ++i) {
    const Progress progress = sample.outcomes[i].progress;
    sample.n_beyond_prefix += progress == Progress::finished ? 1u : 0u;
    sample.n_running += progress == Progress::running ? 1u : 0u;
    sample.n_pending += progress == Progress::pending ? 1u : 0u;
  }
  if (prefix == sample.outcomes.size()) {
    return;
  }
  sample.rule = all_known ? InterimRule::running_censored : InterimRule::complete_prefix;
  if (!all_known) {
    // Those that finished ahead of ones of which nothing is known are the fast ones.
    for (std::size_t i = prefix; i < sample.outcomes.size(); ++i) {
      if (sample.outcomes[i].progress != Progress::failed) {
        RealisationOutcome pending;
        pending.index = sample.outcomes[i].index;
        pending.progress = Progress::pending;
        sample.outcomes[i] = pending;
      }
    }
  }
}

}  // namespace

const char* description_of(InterimRule rule) {
  switch (rule) {
    case InterimRule::complete:
      return "complete: every realisation has finished or failed";
    case InterimRule::running_censored:
      return "interim: survival counts unfinished realisations as censored at the "
             "physical time of their last checkpoint; means, curves and fits are of the "
             "complete prefix in seed order";
    case InterimRule::complete_prefix:
      return "interim: everything is of the complete prefix in seed order, as some "
             "realisations that run have no checkpoint yet";
  }
  return "";
}

std::optional<EnsembleSample> read_ensemble(const Database& database, const Plan& plan,
                                            std::size_t ensemble, const RunFolder& folder,
                                            int wanted) {
  EnsembleSample sample;
  sample.id = id_of(database, plan, plan.ensembles[ensemble]);
  if (sample.id < 0) {
    return std::nullopt;
  }
  sample.tier = plan.ensembles[ensemble].tier;
  Statement rows = database.prepare(
      "SELECT id, idx, status, duration_s, t1_s, tc_s, alpha_deg, grid, tier_run "
      "FROM realisation WHERE ensemble = ? ORDER BY idx");
  rows.bind(1, sample.id);
  Details details(database);
  std::string tier_run;
  bool one_tier = true;
  bool all_known = true;
  while (rows.step()) {
    RealisationOutcome outcome;
    outcome.index = static_cast<std::uint64_t>(rows.integer(1));
    outcome.progress = progress_of(rows.text(2));
    if (outcome.progress == Progress::pending && rows.integer(1) >= wanted) {
      continue;
    }
    if (outcome.progress == Progress::finished) {
      outcome.t1 = optional_real(rows, 4);
      outcome.tc = optional_real(rows, 5);
      outcome.end = std::max({rows.is_null(3) ? 0.0 : rows.real(3),
                              outcome.t1.value_or(0.0), outcome.tc.value_or(0.0)});
      outcome.alpha_deg = optional_real(rows, 6);
      details.read_injections(rows.integer(0), outcome);
      if (sample.n_with_curve < kMostCurves && !rows.is_null(7)) {
        details.read_curves(rows.integer(0), rows.integer(7), outcome);
        sample.n_with_curve += outcome.critical_diameter.time.empty() ? 0u : 1u;
      }
      one_tier = one_tier && (tier_run.empty() || tier_run == rows.text(8));
      tier_run = rows.text(8);
    } else if (outcome.progress != Progress::failed) {
      const Item item{ensemble, static_cast<int>(outcome.index)};
      const bool began = outcome.progress == Progress::running;
      const bool known = read_checkpoint(folder.realisation(plan, item), outcome);
      all_known = all_known && (known || !began);
    }
    sample.outcomes.push_back(std::move(outcome));
  }
  sample.tier = one_tier && !tier_run.empty() ? tier_run : sample.tier;
  settle_interim(sample, all_known);
  return sample;
}

}  // namespace colloid
