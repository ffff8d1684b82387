#include "campaign/plan.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/hash.h"
#include "campaign/seed.h"

namespace colloid {

namespace {

using nlohmann::json;

constexpr int kFormat = 1;  // of campaign.json in the run folder

json limits_json(const Limits& limits) {
  return {{"workers", limits.workers},
          {"seconds_per_realisation", limits.seconds_per_realisation},
          {"seconds_to_stop", limits.seconds_to_stop},
          {"attempts", limits.attempts},
          {"checkpoint_interval", limits.checkpoint_interval}};
}

Limits limits_from(const json& value) {
  Limits limits;
  value.at("workers").get_to(limits.workers);
  value.at("seconds_per_realisation").get_to(limits.seconds_per_realisation);
  value.at("seconds_to_stop").get_to(limits.seconds_to_stop);
  value.at("attempts").get_to(limits.attempts);
  const json& interval = value.at("checkpoint_interval");
  if (interval.is_number()) {  // it was a text once, which no solver took
    interval.get_to(limits.checkpoint_interval);
  }
  return limits;
}

Plan plan_from(const json& value) {
  Plan plan;
  value.at("campaign").get_to(plan.campaign);
  value.at("description").get_to(plan.description);
  value.at("master_seed").get_to(plan.master_seed);
  value.at("independent_points").get_to(plan.independent_points);
  value.at("realisations").get_to(plan.realisations);
  value.at("executor").get_to(plan.executor);
  value.at("ranks").get_to(plan.ranks);
  plan.limits = limits_from(value.at("limits"));
  plan.slurm = read_slurm_options(value.value("slurm", json::object()), "/slurm");
  plan.statistics = value.at("statistics");
  for (const json& point : value.at("points")) {
    plan.points.push_back({point.at("number").get<int>(),
                           point.at("hash").get<std::string>(), point.at("values")});
  }
  for (const json& ensemble : value.at("ensembles")) {
    const auto tier = ensemble.at("tier").get<std::string>();
    plan.ensembles.push_back({ensemble.at("point").get<int>(),
                              tier,
                              ensemble.at("scene"),
                              ensemble.at("scene_hash"),
                              ensemble.value("runs_as", tier),
                              {}});
  }
  return plan;
}

}  // namespace

std::uint64_t seed_of(const Plan& plan, const Item& item) {
  const int number = plan.ensembles[item.ensemble].point;
  const auto point =
      std::find_if(plan.points.begin(), plan.points.end(),
                   [&](const DesignPoint& p) { return p.number == number; });
  return realisation_seed(plan.master_seed, item.index,
                          plan.independent_points ? point->hash : "");
}

std::string hash_of_scene(json scene) {
  scene.erase("description");
  return sha256(scene.dump());  // the library keeps keys sorted
}

json to_json(const Plan& plan) {
  json points = json::array();
  for (const DesignPoint& p : plan.points) {
    points.push_back({{"number", p.number}, {"hash", p.hash}, {"values", p.values}});
  }
  json ensembles = json::array();
  for (const Ensemble& e : plan.ensembles) {
    ensembles.push_back({{"point", e.point},
                         {"tier", e.tier},
                         {"scene", e.scene},
                         {"scene_hash", e.scene_hash},
                         {"runs_as", e.runs_as}});
  }
  return {{"format", kFormat},
          {"campaign", plan.campaign},
          {"description", plan.description},
          {"master_seed", plan.master_seed},
          {"independent_points", plan.independent_points},
          {"realisations", plan.realisations},
          {"executor", plan.executor},
          {"ranks", plan.ranks},
          {"limits", limits_json(plan.limits)},
          {"slurm", to_json(plan.slurm)},
          {"statistics", plan.statistics},
          {"points", points},
          {"ensembles", ensembles}};
}

Plan plan_from_json(const json& value, const std::string& path) {
  try {
    const int format = value.at("format").get<int>();
    if (format != kFormat) {
      throw InputError(
          path, fmt::format("has format {}, this program knows {}", format, kFormat));
    }
    return plan_from(value);
  } catch (const json::exception& error) {
    throw InputError(path,
                     fmt::format("is not a run folder's campaign: {}", error.what()));
  }
}

}  // namespace colloid
