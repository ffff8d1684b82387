#include "commands/regime_json.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNoColloids = "the scene has no colloids";

Json point_json(const StationaryPoint& point) {
  return {{"kind", point.kind == StationaryPoint::Kind::minimum ? "minimum" : "maximum"},
          {"gap_m", point.gap},
          {"energy_J", point.energy},
          {"energy_kT", point.energy_kT}};
}

Json pull_off_json(const ForceAtGap& force) {
  return {{"force_N", force.force}, {"gap_m", force.gap}};
}

Json pair_json(const PairRegime& pair) {
  Json points = Json::array();
  for (const StationaryPoint& p : pair.analysis.stationary_points) {
    points.push_back(point_json(p));
  }
  const PairAnalysis& a = pair.analysis;
  return {{"stationary_points", points},
          {"primary_minimum_kT",
           a.primary_minimum ? Json(a.primary_minimum->energy_kT) : Json(nullptr)},
          {"secondary_minimum_kT",
           a.secondary_minimum ? Json(a.secondary_minimum->energy_kT) : Json(nullptr)},
          {"energy_barrier_kT", a.barrier_from_secondary_kT},
          {"energy_barrier_from_outside_kT", a.barrier_from_outside_kT},
          {"largest_repulsion", pull_off_json(a.largest_repulsion)},
          {"primary_pull_off", pull_off_json(a.primary_pull_off)},
          {"secondary_pull_off", pull_off_json(a.secondary_pull_off)},
          {"capture_gap_m", number_or_null(pair.capture_gap)},
          {"capture_gap_throat_m", number_or_null(pair.capture_gap_throat)},
          {"range_m", number_or_null(pair.range)}};
}

/// The colloid's numbers, whose keys are there with and without colloids.
Json colloid_json(const std::optional<ColloidRegime>& colloids) {
  Json out;
  const ColloidRegime c = colloids.value_or(ColloidRegime{});
  const auto add = [&](const char* key, double value) {
    out[key] = colloids ? number_or_null(value) : Json(nullptr);
  };
  add("reynolds_particle", c.reynolds_particle);
  add("stokes", c.stokes);
  add("stokes_largest", c.stokes_largest);
  add("peclet", c.peclet);
  add("settling_speed_m_s", c.settling_speed);
  add("gravity_number", c.gravity_number);
  add("relaxation_time_s", c.relaxation_time);
  add("debye_length_m", c.debye_length);
  add("capture_gap_m", c.colloid_grain.capture_gap);
  add("energy_barrier_kT", c.colloid_grain.analysis.barrier_from_secondary_kT);
  const auto& minimum = c.colloid_grain.analysis.primary_minimum;
  out["primary_minimum_kT"] =
      minimum ? number_or_null(minimum->energy_kT) : Json(nullptr);
  if (colloids) {
    out["pairs"] = {{"colloid_grain", pair_json(c.colloid_grain)},
                    {"colloid_colloid", pair_json(c.colloid_colloid)}};
  }
  return out;
}

struct NamedDecision {
  const char* name;
  const ModelDecision* decision;  ///< null: a question of colloids, and there are none
};

std::array<NamedDecision, 5> named_decisions(const Regime& regime) {
  const ModelDecisions* models = regime.colloids ? &regime.colloids->models : nullptr;
  return {{{"brownian", models ? &models->brownian : nullptr},
           {"gravity", models ? &models->gravity : nullptr},
           {"inertia", &regime.inertia},
           {"lubrication", models ? &models->lubrication : nullptr},
           {"long_range_dlvo", models ? &models->long_range_dlvo : nullptr}}};
}

std::string row(const std::string& name, double value, const char* unit) {
  return std::isfinite(value) ? fmt::format("{:<26}{:.6g}{}\n", name, value, unit)
                              : fmt::format("{:<26}unbounded\n", name);
}

std::string pair_rows(const char* name, const PairRegime& pair) {
  const auto& minimum = pair.analysis.primary_minimum;
  return fmt::format("\n{}\n", name) + row("capture gap", pair.capture_gap, " m") +
         row("capture gap in the throat", pair.capture_gap_throat, " m") +
         row("range", pair.range, " m") +
         row("energy barrier", pair.analysis.barrier_from_secondary_kT, " kT") +
         (minimum ? row("primary minimum", minimum->energy_kT, " kT")
                  : fmt::format("{:<26}none\n", "primary minimum"));
}

}  // namespace

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json regime_json(const Regime& regime) {
  Json out;
  out["inlet_speed_m_s"] = regime.scales.inlet_speed;
  out["throat_speed_m_s"] = number_or_null(regime.scales.throat_speed);
  out["largest_speed_m_s"] = regime.scales.largest_speed;
  out["reynolds_throat"] = number_or_null(regime.reynolds_throat);
  out.update(colloid_json(regime.colloids));
  for (const auto& [name, decision] : named_decisions(regime)) {
    out["models"][name] = decision ? Json(decision->needed) : Json(nullptr);
    out["reasons"][name] = decision ? decision->reason : kNoColloids;
  }
  return out;
}

std::string regime_table(const Regime& regime) {
  std::string out = row("inlet speed", regime.scales.inlet_speed, " m/s") +
                    row("throat speed", regime.scales.throat_speed, " m/s") +
                    row("largest speed", regime.scales.largest_speed, " m/s") +
                    row("Reynolds, throat", regime.reynolds_throat, "");
  if (regime.colloids) {
    const ColloidRegime& c = *regime.colloids;
    out += row("Reynolds, colloid", c.reynolds_particle, "") +
           row("Stokes", c.stokes, "") + row("Stokes, largest", c.stokes_largest, "") +
           row("Peclet", c.peclet, "") + row("settling speed", c.settling_speed, " m/s") +
           row("gravity number", c.gravity_number, "") +
           row("relaxation time", c.relaxation_time, " s") +
           row("Debye length", c.debye_length, " m") +
           pair_rows("colloid and grain", c.colloid_grain) +
           pair_rows("colloid and colloid", c.colloid_colloid);
  }
  out += "\nmodels\n";
  for (const auto& [name, decision] : named_decisions(regime)) {
    out += fmt::format("{:<16}{:<10}{}\n", name,
                       !decision          ? "-"
                       : decision->needed ? "yes"
                                          : "no",
                       decision ? decision->reason : kNoColloids);
  }
  return out;
}

}  // namespace colloid
