// The fidelity tiers of this program, by name.
#pragma once

#include <optional>
#include <string>

#include "io/realisation.h"
#include "scene/scene.h"
#include "tiers/run_options.h"

namespace colloid {

/// A tier is one function; nothing comes back from an interrupted run.
using TierFunction = std::optional<Realisation> (*)(const Scene&, const RunOptions&);

struct Tier {
  const char* name;  ///< the value of "/fidelity/tier"
  TierFunction run;
};

struct TierDecision {
  Tier tier;
  std::string reason;
};

/// The tier that the scene asks for, or with `auto` the cheapest that is valid for it.
/// Refuses tiers that this program does not have.
TierDecision choose_tier(const Scene& scene);

}  // namespace colloid
