// A campaign as its author wrote it: one scene, varied, many realisations, tiers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/slurm_options.h"

namespace colloid {

/// What one realisation may cost, and how hard it is tried.
struct Limits {
  int workers = 0;                           ///< at once; 0: one per core
  double seconds_per_realisation = 86400.0;  ///< wall time of one attempt [s]
  double seconds_to_stop = 30.0;             ///< from a polite stop to a kill [s]
  int attempts = 2;                          ///< before a realisation counts as failed
  double checkpoint_interval = 600.0;        ///< wall time between two [s]
};

struct Campaign {
  std::string name;
  std::string description;
  nlohmann::json scene;    ///< as given, not yet checked
  std::string scene_path;  ///< the file it came from; empty: it stands in the campaign
  std::vector<std::string> tiers;  ///< of the scene if empty
  nlohmann::json fidelity;         ///< overrides the scene's, key by key
  std::map<std::string, std::vector<nlohmann::json>> vary;  ///< JSON pointer -> values
  int realisations = 0;
  std::string master_seed;  ///< an unsigned integer of 64 bits, as text
  bool independent_points = false;
  std::string executor = "local";
  int ranks = 1;  ///< processes of one realisation
  Limits limits;
  SlurmOptions slurm;
  nlohmann::json statistics;  ///< options of the statistics

  std::string path;  ///< the file it came from
  std::string text;  ///< of that file, so that a later refusal can name the line
};

}  // namespace colloid
