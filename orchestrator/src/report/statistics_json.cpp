#include "report/statistics_json.h"

#include <cmath>

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using statistics::Interval;

Json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

void put_interval(Json& out, const std::optional<Interval>& interval) {
  out["ci_low"] = interval ? or_null(interval->low) : Json();
  out["ci_high"] = interval ? or_null(interval->high) : Json();
}

void put_note(Json& out, const std::string& note) {
  if (!note.empty()) {
    out["note"] = note;
  }
}

Json mean_json(const statistics::MeanTime& time) {
  Json out{{"mean", or_null(time.student.mean)},
           {"sd", or_null(time.student.sd)},
           {"n", time.student.n}};
  put_interval(out, time.student.interval);
  out["method"] = time.student.method;
  put_note(out, time.student.note);
  Json bootstrap = Json::object();
  put_interval(bootstrap, time.bootstrap.bca);
  bootstrap["method"] = "BCa bootstrap (Efron 1987)";
  bootstrap["resamples"] = time.bootstrap.resamples;
  put_note(bootstrap, time.bootstrap.note);
  out["bootstrap"] = std::move(bootstrap);
  return out;
}

Json limits(const std::optional<double>& low, const std::optional<double>& high) {
  return Json::array({or_null(low), or_null(high)});
}

Json clogging_json(const statistics::Clogging& clogging) {
  Json out{{"kaplan_meier", survival_json(clogging.kaplan_meier, 0)},
           {"median_s", or_null(clogging.median.estimate)},
           {"median_ci", limits(clogging.median.low, clogging.median.high)},
           {"median_method", clogging.median.method}};
  const auto& mean = clogging.restricted_mean;
  out["restricted_mean_s"] = mean ? or_null(mean->mean) : Json();
  out["restricted_mean_ci"] = mean ? pair_of(mean->interval) : Json();
  if (mean) {
    out["restricted_mean_tau_s"] = mean->tau;
    out["restricted_mean_method"] = mean->method;
    if (!mean->note.empty()) {
      out["restricted_mean_note"] = mean->note;
    }
  }
  const auto& by_end = clogging.probability_by_end;
  out["probability_by_end"] = by_end ? or_null(by_end->estimate) : Json();
  out["probability_ci"] = by_end ? pair_of(by_end->interval) : Json();
  if (by_end) {
    out["probability_time_s"] = by_end->time;
    out["probability_method"] = by_end->method;
    if (!by_end->note.empty()) {
      out["probability_note"] = by_end->note;
    }
  }
  return out;
}

Json numbers_json(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double value : values) {
    out.push_back(or_null(value));
  }
  return out;
}

Json ends(const std::vector<Interval>& intervals, double Interval::*end) {
  Json out = Json::array();
  for (const Interval& interval : intervals) {
    out.push_back(or_null(interval.*end));
  }
  return out;
}

Json curve_json(const statistics::MeanCurve& curve) {
  Json out{{"n", curve.n},
           {"mean", numbers_json(curve.mean)},
           {"sd", numbers_json(curve.sd)},
           {"ci_low", ends(curve.interval, &Interval::low)},
           {"ci_high", ends(curve.interval, &Interval::high)},
           {"band_low", ends(curve.band, &Interval::low)},
           {"band_high", ends(curve.band, &Interval::high)},
           {"ci_method", curve.interval_method},
           {"band_method", curve.band_method}};
  put_note(out, curve.note);
  return out;
}

Json alpha_json(const statistics::AlphaFit& fit) {
  Json out{{"slope_s_per_deg", or_null(fit.line.slope)},
           {"intercept_s", or_null(fit.line.intercept)},
           {"slope_ci", pair_of(fit.line.slope_interval)},
           {"intercept_ci", pair_of(fit.line.intercept_interval)},
           {"r_squared", or_null(fit.line.r_squared)},
           {"n", fit.line.n},
           {"n_excluded", fit.n_excluded},
           {"method", fit.line.method}};
  put_note(out, fit.line.note);
  if (fit.with_censored) {
    const statistics::CensoredFit& all = *fit.with_censored;
    Json with{{"slope_s_per_deg", or_null(all.slope)},
              {"intercept_s", or_null(all.intercept)},
              {"slope_ci", pair_of(all.slope_interval)},
              {"intercept_ci", pair_of(all.intercept_interval)},
              {"n", all.n},
              {"n_censored", all.n_censored},
              {"method", all.method}};
    put_note(with, all.note);
    out["censored_regression"] = std::move(with);
  } else {
    out["censored_regression"] = nullptr;
  }
  return out;
}

/// `unit`: of the amplitude; the keys of a probability have none.
void put_fit(Json& out, const statistics::ExponentialFit& fit) {
  out["amplitude"] = or_null(fit.amplitude);
  out["rate_per_m"] = or_null(fit.rate);
  out["amplitude_ci"] = pair_of(fit.amplitude_interval);
  out["rate_ci"] = pair_of(fit.rate_interval);
  out["r_squared"] = or_null(fit.r_squared);
  out["method"] = fit.method;
  out["resamples"] = fit.resamples;
  put_note(out, fit.note);
}

Json profile_json(const statistics::InjectionProfile& profile) {
  Json out{{"order", profile.order},
           {"n", profile.n},
           {"n_without", profile.n_without},
           {"annulus_centre_m", numbers_json(profile.centre)}};
  Json probability = Json::array();
  Json low = Json::array();
  Json high = Json::array();
  for (const statistics::Proportion& p : profile.probability) {
    probability.push_back(or_null(p.estimate));
    low.push_back(p.interval ? or_null(p.interval->low) : Json());
    high.push_back(p.interval ? or_null(p.interval->high) : Json());
  }
  out["probability"] = std::move(probability);
  out["probability_ci_low"] = std::move(low);
  out["probability_ci_high"] = std::move(high);
  put_fit(out, profile.probability_fit);
  out["density_per_m2"] = numbers_json(profile.density);
  Json density = Json::object();
  put_fit(density, profile.density_fit);
  out["density_fit"] = std::move(density);
  return out;
}

}  // namespace

Json pair_of(const std::optional<Interval>& interval) {
  return interval ? limits(interval->low, interval->high) : Json();
}

Json survival_json(const statistics::KaplanMeier& curve, std::size_t most) {
  Json time = Json::array();
  Json survival = Json::array();
  Json low = Json::array();
  Json high = Json::array();
  Json censored = Json::array();
  const std::size_t steps = curve.steps.size();
  const std::size_t stride = most == 0 || steps <= most ? 1 : (steps + most - 1) / most;
  for (std::size_t i = 0; i < steps; ++i) {
    if (i % stride != 0 && i + 1 != steps) {
      continue;
    }
    const statistics::SurvivalStep& step = curve.steps[i];
    time.push_back(step.time);
    survival.push_back(step.survival);
    low.push_back(step.interval.low);
    high.push_back(step.interval.high);
    censored.push_back(step.censored);
  }
  return {{"n", curve.n},
          {"n_events", curve.n_events},
          {"time_s", std::move(time)},
          {"survival", std::move(survival)},
          {"ci_low", std::move(low)},
          {"ci_high", std::move(high)},
          {"censored", std::move(censored)},
          {"method", curve.method}};
}

Json to_json(const statistics::PointStatistics& point) {
  Json injection = Json::array();
  for (const statistics::InjectionProfile& profile : point.injection) {
    injection.push_back(profile_json(profile));
  }
  return {{"n", point.n},
          {"n_censored", point.n_censored},
          {"n_failed", point.n_failed},
          {"confidence", point.level},
          {"t1", mean_json(point.t1)},
          {"tc", mean_json(point.tc)},
          {"tc_minus_t1", mean_json(point.tc_minus_t1)},
          {"median_t1_s", or_null(point.median_t1.estimate)},
          {"median_t1_ci", limits(point.median_t1.low, point.median_t1.high)},
          {"clogging", clogging_json(point.clogging)},
          {"curves",
           {{"time_s", point.curves.time},
            {"critical_diameter", curve_json(point.curves.critical_diameter)},
            {"permeability_ratio", curve_json(point.curves.permeability_ratio)}}},
          {"stages",
           {{"end_of_first_s", or_null(point.stages.end_of_first)},
            {"end_of_second_s", or_null(point.stages.end_of_second)},
            {"end_of_third_s", or_null(point.stages.end_of_third)}}},
          {"alpha_fit", alpha_json(point.alpha_fit)},
          {"injection_fits", std::move(injection)},
          {"warnings", point.warnings}};
}

}  // namespace colloid
