#include "campaign/changes.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace colloid {

namespace {

using nlohmann::json;
using Key = std::pair<std::string, std::string>;  // hash of the design point, tier

const DesignPoint& point_of(const Plan& plan, const Ensemble& ensemble) {
  return *std::find_if(plan.points.begin(), plan.points.end(),
                       [&](const auto& p) { return p.number == ensemble.point; });
}

std::map<Key, const Ensemble*> by_key(const Plan& plan) {
  std::map<Key, const Ensemble*> out;
  for (const Ensemble& ensemble : plan.ensembles) {
    out[{point_of(plan, ensemble).hash, ensemble.tier}] = &ensemble;
  }
  return out;
}

std::string name_of(const Plan& plan, const Ensemble& ensemble) {
  const DesignPoint& point = point_of(plan, ensemble);
  return fmt::format("design point {} {} in tier {}", point.number, point.values.dump(),
                     ensemble.tier);
}

std::string value_at(const json& scene, const std::string& pointer) {
  const json::json_pointer at(pointer);
  return scene.contains(at) ? scene[at].dump() : "nothing";
}

void list_differences(const json& before, const json& after, const std::string& name,
                      std::vector<std::string>& out) {
  for (const json& step : json::diff(before, after)) {
    const auto pointer = step.at("path").get<std::string>();
    if (pointer == "/description") {
      continue;
    }
    const std::string line = fmt::format(
        "{}: {} -> {}", pointer, value_at(before, pointer), value_at(after, pointer));
    const bool known = std::any_of(out.begin(), out.end(), [&](const std::string& other) {
      return other.compare(0, line.size(), line) == 0;
    });
    if (!known) {
      out.push_back(fmt::format("{} (first in {})", line, name));
    }
  }
}

}  // namespace

std::vector<std::string> forbidden_changes(const Plan& old_plan, const Plan& new_plan) {
  std::vector<std::string> out;
  if (old_plan.master_seed != new_plan.master_seed) {
    out.push_back(fmt::format("/master_seed: {} -> {}", old_plan.master_seed,
                              new_plan.master_seed));
  }
  if (old_plan.independent_points != new_plan.independent_points) {
    out.push_back(fmt::format("/independent_points: {} -> {}",
                              old_plan.independent_points, new_plan.independent_points));
  }
  if (old_plan.ranks != new_plan.ranks) {
    out.push_back(fmt::format("/ranks: {} -> {} (sums in another order)", old_plan.ranks,
                              new_plan.ranks));
  }
  const auto ensembles = by_key(new_plan);
  for (const auto& [key, before] : by_key(old_plan)) {
    const auto after = ensembles.find(key);
    if (after == ensembles.end()) {
      out.push_back(name_of(old_plan, *before) + " is no longer there");
    } else if (after->second->scene_hash != before->scene_hash) {
      list_differences(before->scene, after->second->scene, name_of(old_plan, *before),
                       out);
    }
  }
  return out;
}

Plan continued(const Plan& old_plan, Plan new_plan) {
  new_plan.realisations = std::max(old_plan.realisations, new_plan.realisations);
  std::map<std::string, int> numbers;
  for (const DesignPoint& point : old_plan.points) {
    numbers[point.hash] = point.number;
  }
  std::map<int, int> renumbered;
  for (DesignPoint& point : new_plan.points) {
    const auto [known, is_new] =
        numbers.emplace(point.hash, static_cast<int>(numbers.size()));
    renumbered[point.number] = known->second;
    point.number = known->second;
  }
  for (Ensemble& ensemble : new_plan.ensembles) {
    ensemble.point = renumbered.at(ensemble.point);
  }
  std::sort(new_plan.points.begin(), new_plan.points.end(),
            [](const auto& a, const auto& b) { return a.number < b.number; });
  std::stable_sort(new_plan.ensembles.begin(), new_plan.ensembles.end(),
                   [](const auto& a, const auto& b) { return a.point < b.point; });
  return new_plan;
}

}  // namespace colloid
