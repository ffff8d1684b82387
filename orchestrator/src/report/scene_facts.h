// What the statistics need to know of a scene as the solver spells it out: SI, every
// default there.  Read, not computed: the orchestrator knows no physics.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "statistics/annuli.h"

namespace colloid {

struct SceneFacts {
  std::optional<double> duration;            ///< [s]
  std::optional<double> colloid_diameter;    ///< [m]
  std::optional<statistics::Section> inlet;  ///< if it is a face z+ or z- [m]
  double inlet_margin = 0.0;  ///< a radius, and the capture gap if it is given [m]
  bool stops_when_clogged = false;
};

SceneFacts scene_facts(const nlohmann::json& scene);

}  // namespace colloid
