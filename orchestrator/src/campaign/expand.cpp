#include "campaign/expand.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/json_text.h"
#include "base/text.h"
#include "campaign/read_campaign.h"

namespace colloid {

namespace {

using nlohmann::json;
using namespace nlohmann::literals;

/// One choice of a value for every varied pointer: its index in the list.
using Choice = std::map<std::string, std::size_t>;

std::vector<Choice> choices(const Campaign& campaign) {
  std::vector<Choice> out{{}};
  for (const auto& [pointer, values] : campaign.vary) {
    std::vector<Choice> longer;
    longer.reserve(out.size() * values.size());
    for (const Choice& choice : out) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        longer.push_back(choice);
        longer.back()[pointer] = i;
      }
    }
    out = std::move(longer);
  }
  return out;
}

std::string vary_pointer(const std::string& pointer, std::size_t index) {
  return fmt::format("{}/{}", join_pointer("/vary", pointer), index);
}

/// The folder that file names in the scene are relative to.
std::filesystem::path folder_of(const Campaign& campaign) {
  const std::string& anchor =
      campaign.scene_path.empty() ? campaign.path : campaign.scene_path;
  return std::filesystem::path(anchor).parent_path();
}

json patched(const Campaign& campaign, const Choice& choice, const std::string& tier) {
  json scene = campaign.scene;
  if (!campaign.fidelity.empty()) {
    scene["fidelity"].merge_patch(campaign.fidelity);
  }
  for (const auto& [pointer, index] : choice) {
    try {
      scene[json::json_pointer(pointer)] = campaign.vary.at(pointer)[index];
    } catch (const json::exception& error) {
      refuse(campaign, join_pointer("/vary", pointer),
             fmt::format("does not point into the scene: {}", error.what()));
    }
  }
  if (!tier.empty()) {
    scene["fidelity"]["tier"] = tier;
  }
  // The patched scene is read from another folder.
  const json::json_pointer table("/geometry/spheres_file");
  if (scene.contains(table) && scene[table].is_string() &&
      !scene[table].get<std::string>().empty()) {
    scene[table] =
        absolute((folder_of(campaign) / scene[table].get<std::string>()).string());
  }
  return scene;
}

/// Is `pointer` that of `outer`, or of something in it?
bool is_within(const std::string& pointer, const std::string& outer) {
  return pointer.compare(0, outer.size(), outer) == 0 &&
         (pointer.size() == outer.size() || pointer[outer.size()] == '/');
}

/// Says again what the solver said of a file of ours, of the line the user wrote.
[[noreturn]] void refuse_scene(const Campaign& campaign, const Choice& choice,
                               const std::string& complaint) {
  // What the scene says wrongly is said of a line; what its flow shows, of a pointer
  // only.
  std::string rest = complaint;
  if (rest.rfind('/', 0) != 0) {
    const std::size_t at = complaint.find(": /");
    if (at == std::string::npos) {
      throw InputError(campaign.path, "the scene is refused: " + complaint);
    }
    rest = complaint.substr(at + 2);
  }
  const std::string pointer = rest.substr(0, rest.find(": "));
  const std::string why =
      rest.size() > pointer.size() + 2 ? rest.substr(pointer.size() + 2) : "is refused";
  for (const auto& [varied, index] : choice) {
    const bool made_by_it = is_within(varied, pointer) &&
                            !campaign.scene.contains(json::json_pointer(pointer));
    if (is_within(pointer, varied) || made_by_it) {
      refuse(campaign, vary_pointer(varied, index),
             fmt::format("as {} of the scene: {}", pointer, why));
    }
  }
  const std::string fidelity = "/fidelity/";
  if (pointer.compare(0, fidelity.size(), fidelity) == 0 &&
      (campaign.fidelity.contains(pointer.substr(fidelity.size())) ||
       (pointer == "/fidelity/tier" && !campaign.tiers.empty()))) {
    refuse(campaign, pointer, why);
  }
  if (campaign.scene_path.empty()) {
    refuse(campaign, pointer == "/" ? "/scene" : "/scene" + pointer, why);
  }
  throw InputError(
      campaign.scene_path + " " + locate(read_text_file(campaign.scene_path), pointer),
      pointer + ": " + why);
}

json spelt_out(const Campaign& campaign, const SolverProgram& solver,
               const Choice& choice, const std::string& tier) {
  try {
    return solver.spell_out(patched(campaign, choice, tier));
  } catch (const InputError& error) {
    if (error.where() != "scene") {
      throw;
    }
    refuse_scene(campaign, choice, error.why());
  }
}

/// Of a scene whose tier is auto: the solver measures its flow to say what that means.
json regime_of(const Campaign& campaign, const SolverProgram& solver,
               const Choice& choice, const json& scene) {
  try {
    return solver.regime(scene);
  } catch (const InputError& error) {
    if (error.where() != "scene") {
      throw;
    }
    refuse_scene(campaign, choice, error.why());
  }
}

DesignPoint design_point(const Campaign& campaign, const Choice& choice,
                         const json& scene) {
  DesignPoint point;
  point.values = json::object();
  for (const auto& [pointer, index] : choice) {
    const json::json_pointer at(pointer);
    point.values[pointer] =
        scene.contains(at) ? scene[at] : campaign.vary.at(pointer)[index];
  }
  point.hash = sha256(point.values.dump());
  return point;
}

void refuse_if_same(const Campaign& campaign, const Plan& plan, const DesignPoint& point,
                    const Choice& choice) {
  const bool same = std::any_of(plan.points.begin(), plan.points.end(),
                                [&](const auto& p) { return p.hash == point.hash; });
  if (same) {
    const auto& [pointer, index] = *choice.rbegin();
    refuse(campaign, vary_pointer(pointer, index),
           "gives the same design point as another value of the list");
  }
}

}  // namespace

Plan expand(const Campaign& campaign, const SolverProgram& solver) {
  Plan plan{campaign.name,
            campaign.description,
            campaign.master_seed,
            campaign.independent_points,
            campaign.realisations,
            campaign.executor,
            campaign.ranks,
            campaign.limits,
            campaign.slurm,
            campaign.statistics,
            {},
            {}};
  const std::vector<std::string> tiers =
      campaign.tiers.empty() ? std::vector<std::string>{""} : campaign.tiers;
  for (const Choice& choice : choices(campaign)) {
    const int number = static_cast<int>(plan.points.size());
    for (const std::string& tier : tiers) {
      json scene = spelt_out(campaign, solver, choice, tier);
      if (plan.points.size() == static_cast<std::size_t>(number)) {
        DesignPoint point = design_point(campaign, choice, scene);
        refuse_if_same(campaign, plan, point, choice);
        point.number = number;
        plan.points.push_back(std::move(point));
      }
      const std::string chosen = scene.at("fidelity").at("tier").get<std::string>();
      const json regime =
          chosen == "auto" ? regime_of(campaign, solver, choice, scene) : json::object();
      const auto runs = regime.value("/tier/name"_json_pointer, chosen);
      if (campaign.ranks > 1 && runs != "transient") {
        refuse(campaign, "/ranks",
               fmt::format("is {}, but a realisation of tier {} is one process",
                           campaign.ranks, runs));
      }
      const std::string hash = hash_of_scene(scene);
      plan.ensembles.push_back({number, chosen, std::move(scene), hash, runs, regime});
    }
  }
  return plan;
}

}  // namespace colloid
