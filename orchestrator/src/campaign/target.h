// The key /statistics/target of a campaign: how well a number is to be known, after which
// no more realisations are run.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace colloid {

struct Target {
  std::string statistic;    ///< as `poreclog statistics` names it
  double half_width = 0.0;  ///< of its interval; s, or 1 for a probability
  int pilot = 20;           ///< realisations before the first decision
  int batch = 10;           ///< from one decision to the next
};

/// `realisations`: of each ensemble, at most; there has to be room for a decision.
Target read_target(const nlohmann::json& value, int realisations);

/// Of a plan's options of the statistics; none if it has no target.
std::optional<Target> target_of(const nlohmann::json& statistics, int realisations);

/// The half-width of t1 is at most 0.05 s.
std::string aim_of(const Target& target);

/// s, or empty for a probability.
std::string unit_of(const Target& target);

}  // namespace colloid
