// A campaign worked out: design points with their scenes as the solver spells them out,
// and the realisations of each.  Kept as campaign.json in the campaign's run folder, from
// which (with the attempts' folders) the database can be rebuilt.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/campaign.h"

namespace colloid {

/// One combination of varied values.
// The library's move constructor checks an invariant that cannot fail.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct DesignPoint {
  int number = 0;         ///< in order of first appearance; for people
  std::string hash;       ///< of `values`: what identifies it
  nlohmann::json values;  ///< JSON pointer -> value as the solver spells it out
};

/// The realisations of one design point in one tier.
struct Ensemble {
  int point = 0;           ///< number of the design point
  std::string tier;        ///< as asked for: may be "auto"
  nlohmann::json scene;    ///< every default spelled out
  std::string scene_hash;  ///< of the scene without its remark
  std::string runs_as;    ///< the tier that runs: `tier`, or what the solver says auto is
  nlohmann::json regime;  ///< that the solver was asked for to say so; not kept in files
};

struct Plan {  // NOLINT(bugprone-exception-escape): as above
  std::string campaign;
  std::string description;
  std::string master_seed;
  bool independent_points = false;
  int realisations = 0;  ///< of each ensemble
  std::string executor;
  int ranks = 1;
  Limits limits;
  SlurmOptions slurm;
  nlohmann::json statistics;
  std::vector<DesignPoint> points;
  std::vector<Ensemble> ensembles;
};

/// One realisation: an ensemble of a plan, and the index in it.
struct Item {
  std::size_t ensemble = 0;
  int index = 0;
};

std::uint64_t seed_of(const Plan& plan, const Item& item);

/// SHA-256 of the scene without /description: equal hashes, equal physics and numerics.
std::string hash_of_scene(nlohmann::json scene);

nlohmann::json to_json(const Plan& plan);
/// `path` names the file in messages.
Plan plan_from_json(const nlohmann::json& json, const std::string& path);

}  // namespace colloid
