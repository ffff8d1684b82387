#include "commands/regime_json.h"

#include <cmath>

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

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
          {"capture_gap_m", pair.capture_gap},
          {"capture_gap_throat_m", pair.capture_gap_throat},
          {"range_m", pair.range}};
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
  if (!regime.colloids) {
    return out;
  }
  const ColloidRegime& c = *regime.colloids;
  out["reynolds_particle"] = c.reynolds_particle;
  out["stokes"] = c.stokes;
  out["stokes_largest"] = c.stokes_largest;
  out["peclet"] = c.peclet;
  out["settling_speed_m_s"] = c.settling_speed;
  out["gravity_number"] = number_or_null(c.gravity_number);
  out["relaxation_time_s"] = c.relaxation_time;
  out["debye_length_m"] = c.debye_length;
  out["capture_gap_m"] = c.colloid_grain.capture_gap;
  out["energy_barrier_kT"] = c.colloid_grain.analysis.barrier_from_secondary_kT;
  const auto& minimum = c.colloid_grain.analysis.primary_minimum;
  out["primary_minimum_kT"] = minimum ? Json(minimum->energy_kT) : Json(nullptr);
  out["pairs"] = {{"colloid_grain", pair_json(c.colloid_grain)},
                  {"colloid_colloid", pair_json(c.colloid_colloid)}};
  const std::array<std::pair<const char*, const ModelDecision*>, 5> models{
      {{"brownian", &c.models.brownian},
       {"gravity", &c.models.gravity},
       {"inertia", &c.models.inertia},
       {"lubrication", &c.models.lubrication},
       {"long_range_dlvo", &c.models.long_range_dlvo}}};
  for (const auto& [name, decision] : models) {
    out["models"][name] = decision->needed;
    out["reasons"][name] = decision->reason;
  }
  return out;
}

}  // namespace colloid
