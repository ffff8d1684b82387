#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/prefix.h"
#include "statistics/resampler.h"

namespace colloid::statistics {

namespace {

using Finished = std::vector<const RealisationOutcome*>;

constexpr std::size_t kOrders = 5;  // of retention, in the injection profiles

/// What a seed is used for: each gets its own.
enum class Use { t1, tc, tc_minus_t1, critical_diameter, permeability_ratio, injection };

BootstrapOptions options_for(const BootstrapOptions& options, Use use,
                             std::size_t part = 0) {
  BootstrapOptions own = options;
  own.seed = derive_seed(options.seed, 16 * static_cast<std::uint64_t>(use) + part);
  return own;
}

std::string of_realisation(const RealisationOutcome& outcome, const std::string& what) {
  return "realisation " + std::to_string(outcome.index) + ": " + what;
}

void check(const RealisationOutcome& outcome) {
  for (const auto& [value, name] :
       {std::pair{outcome.t1, "t_1"}, std::pair{outcome.tc, "t_c"},
        std::pair{std::optional(outcome.end), "end"},
        std::pair{outcome.alpha_deg, "alpha"},
        std::pair{outcome.diameter_lost, "critical diameter lost"}}) {
    if (value) {
      require_finite({*value}, of_realisation(outcome, name));
    }
  }
  if (outcome.tc.value_or(0.0) > outcome.end || outcome.t1.value_or(0.0) > outcome.end) {
    throw InvalidSample(of_realisation(
        outcome, "an event lies after its end, " + std::to_string(outcome.end) + " s"));
  }
}

/// A mean of what every realisation has; without it where one has it not.
template <class Value>
MeanTime mean_time(const Finished& finished, const BootstrapOptions& options,
                   const std::string& what_lacks, const Value& value) {
  std::vector<double> sample;
  sample.reserve(finished.size());
  for (const RealisationOutcome* outcome : finished) {
    const std::optional<double> x = value(*outcome);
    if (x) {
      sample.push_back(*x);
    }
  }
  const std::size_t missing = finished.size() - sample.size();
  if (missing == 0) {
    return {mean_interval(sample, options.level), bootstrap_mean(sample, options)};
  }
  // A mean of the others would be too low: those that lack it are the late ones.
  MeanTime result{mean_interval({}, options.level), bootstrap_mean({}, options)};
  result.student.n = finished.size();
  result.bootstrap.n = finished.size();
  result.student.note = std::to_string(missing) + " of " +
                        std::to_string(finished.size()) + " realisations " + what_lacks +
                        ": no mean";
  result.bootstrap.note = result.student.note;
  return result;
}

void fill_means(const Finished& finished, const BootstrapOptions& bootstrap,
                PointStatistics& point) {
  point.t1 = mean_time(finished, options_for(bootstrap, Use::t1), "retained nothing",
                       [](const RealisationOutcome& o) { return o.t1; });
  point.tc = mean_time(finished, options_for(bootstrap, Use::tc), "did not clog",
                       [](const RealisationOutcome& o) { return o.tc; });
  point.tc_minus_t1 =
      mean_time(finished, options_for(bootstrap, Use::tc_minus_t1),
                "did not clog or retained nothing", [](const RealisationOutcome& o) {
                  return o.tc && o.t1 ? std::optional(*o.tc - *o.t1) : std::nullopt;
                });
}

Clogging clogging_of(std::vector<Observation> observations,
                     const std::optional<double>& tau, double level) {
  if (tau) {
    snap_to(observations, *tau);
  }
  Clogging result;
  result.kaplan_meier = kaplan_meier(observations, level);
  result.median = median_time(result.kaplan_meier);
  if (tau) {
    result.restricted_mean = restricted_mean(result.kaplan_meier, *tau);
    result.probability_by_end = event_probability(observations, *tau, level);
  }
  return result;
}

/// The mean of one recorded quantity over the realisations that have it.
MeanCurve ensemble_curve(const Finished& finished, StepSeries RealisationOutcome::*series,
                         const std::vector<double>& grid, bool hold_last,
                         const BootstrapOptions& options) {
  std::vector<std::vector<double>> curves;
  curves.reserve(finished.size());
  for (const RealisationOutcome* outcome : finished) {
    const StepSeries& recorded = outcome->*series;
    if (!recorded.time.empty()) {
      require_finite(recorded.value, of_realisation(*outcome, "a recorded series"));
      curves.push_back(on_grid(recorded, grid, hold_last));
    }
  }
  MeanCurve curve = mean_curve(curves, options);
  if (curves.size() < finished.size() && !curves.empty()) {
    curve.note = std::to_string(finished.size() - curves.size()) +
                 " realisations without a curve are left out";
  }
  return curve;
}

/// The latest time that all curves cover.
double common_end(const Finished& finished) {
  double end = HUGE_VAL;
  for (const RealisationOutcome* outcome : finished) {
    for (const StepSeries* series :
         {&outcome->critical_diameter, &outcome->permeability_ratio}) {
      if (!series->time.empty()) {
        end = std::min(end, series->time.back());
      }
    }
  }
  return end;
}

void fill_curves(const Finished& finished, const std::optional<double>& duration,
                 const SummaryOptions& options, PointStatistics& point) {
  const double recorded = common_end(finished);
  if (!std::isfinite(recorded)) {
    return;  // no realisation has a curve
  }
  double end = duration.value_or(recorded);
  if (!options.hold_last && recorded < end) {
    if (recorded < end * (1.0 - 1e-9)) {
      point.warnings.push_back("the mean curves end at " + std::to_string(recorded) +
                               " s, where the shortest realisation ends");
    }
    end = recorded;
  }
  if (options.hold_last && recorded < end) {
    point.warnings.push_back(
        "runs stopped when clogged: their curves keep the last value");
  }
  if (!(end > 0.0)) {
    return;
  }
  EnsembleCurves& curves = point.curves;
  curves.time = uniform_grid(end, options.grid_points);
  curves.critical_diameter = ensemble_curve(
      finished, &RealisationOutcome::critical_diameter, curves.time, options.hold_last,
      options_for(options.bootstrap, Use::critical_diameter));
  curves.permeability_ratio = ensemble_curve(
      finished, &RealisationOutcome::permeability_ratio, curves.time, options.hold_last,
      options_for(options.bootstrap, Use::permeability_ratio));
}

Stages stages_of(const PointStatistics& point,
                 const std::optional<double>& colloid_diameter) {
  constexpr double kSettled = 0.05;  // share of the steepest change of the deviation
  Stages stages;
  stages.end_of_first = point.median_t1.estimate;
  const EnsembleCurves& curves = point.curves;
  if (colloid_diameter && !curves.critical_diameter.mean.empty()) {
    stages.end_of_second =
        first_fall_to(*colloid_diameter, curves.time, curves.critical_diameter.mean);
  }
  if (!curves.critical_diameter.sd.empty()) {
    stages.end_of_third =
        settling_time(curves.time, curves.critical_diameter.sd, kSettled);
  }
  return stages;
}

std::vector<InjectionProfile> injection_of(const Finished& finished,
                                           const SummaryOptions& options) {
  const Annuli annuli(*options.inlet, options.annulus_width);
  std::vector<std::vector<std::array<double, 2>>> positions;
  positions.reserve(finished.size());
  for (const RealisationOutcome* outcome : finished) {
    positions.push_back(outcome->injection_positions);
  }
  std::vector<InjectionProfile> profiles;
  profiles.reserve(kOrders);
  for (std::size_t order = 1; order <= kOrders; ++order) {
    profiles.push_back(
        injection_profile(order, positions, annuli, options.inlet_margin,
                          options_for(options.bootstrap, Use::injection, order)));
  }
  return profiles;
}

void count(const std::vector<RealisationOutcome>& outcomes, PointStatistics& point) {
  std::size_t finished = 0;
  for (const RealisationOutcome& outcome : outcomes) {
    switch (outcome.progress) {
      case Progress::finished:
        ++finished;
        break;
      case Progress::running:
        ++point.n_running;
        break;
      case Progress::failed:
        ++point.n_failed;
        break;
      case Progress::pending:
        ++point.n_pending;
        break;
    }
  }
  point.n_beyond_prefix = finished - point.n;
  if (point.n_failed > 0) {
    point.warnings.push_back(
        std::to_string(point.n_failed) + " of " + std::to_string(outcomes.size()) +
        " realisations failed and are left out: if failing goes with clogging, every "
        "number here is biased");
  }
  if (point.n_running > 0 || point.n_beyond_prefix > 0) {
    point.warnings.push_back(
        "interim: means, curves and fits are of the first " + std::to_string(point.n) +
        " realisations, " + std::to_string(point.n_beyond_prefix) +
        " have finished after one that has not; the runs that take long are missing, so "
        "times are too short until all have finished.  Survival counts the running ones "
        "as censored");
  }
}

/// tau: the campaign's duration, or for want of one the longest time reached.
std::optional<double> duration_of(const std::vector<RealisationOutcome>& outcomes,
                                  const SummaryOptions& options,
                                  std::vector<std::string>& warnings) {
  if (options.duration) {
    return options.duration;
  }
  double longest = 0.0;
  for (const RealisationOutcome& outcome : outcomes) {
    if (outcome.progress == Progress::finished) {
      longest = std::max(longest, outcome.end);
    }
  }
  if (!(longest > 0.0)) {
    return std::nullopt;
  }
  warnings.push_back("no duration given: the restricted mean goes to the longest time, " +
                     std::to_string(longest) + " s, which the sample chose");
  return longest;
}

}  // namespace

PointStatistics summarise(const std::vector<RealisationOutcome>& outcomes,
                          const SummaryOptions& options) {
  require_level(options.bootstrap.level);
  const double level = options.bootstrap.level;
  for (const RealisationOutcome& outcome : outcomes) {
    check(outcome);
  }
  const Prefix prefix = complete_prefix(outcomes);
  PointStatistics point;
  point.level = level;
  point.n = prefix.finished.size();
  count(outcomes, point);
  for (const RealisationOutcome* outcome : prefix.finished) {
    point.n_censored += outcome->tc ? 0u : 1u;
  }
  std::vector<Observation> clogged;
  std::vector<Observation> retained;
  for (const RealisationOutcome* outcome : all_started(outcomes)) {
    clogged.push_back(clogging(*outcome));
    retained.push_back(first_retention(*outcome));
  }
  fill_means(prefix.finished, options.bootstrap, point);
  point.median_t1 = median_time(kaplan_meier(std::move(retained), level));
  const std::optional<double> tau = duration_of(outcomes, options, point.warnings);
  point.clogging = clogging_of(std::move(clogged), tau, level);
  fill_curves(prefix.finished, tau, options, point);
  point.stages = stages_of(point, options.colloid_diameter);
  point.alpha_fit = alpha_fit(prefix.finished, level);
  if (options.inlet) {
    point.injection = injection_of(prefix.finished, options);
  }
  return point;
}

}  // namespace colloid::statistics
