// What `describe --regime` shows, found by measuring the scene.  Apart from describe.cpp,
// because the scene's list of keys and the flow's unknowns are both named Fields.
#pragma once

#include <optional>
#include <string>

#include "tiers/regime.h"
#include "tiers/tier.h"
#include "tiers/transient_cost.h"

namespace colloid {

struct SceneRegime {
  Regime regime;
  TierAdvice tier;                    ///< asked for by the scene, or what `auto` means
  std::optional<TransientCost> cost;  ///< of a run by the tier transient; else not known
};

/// Of the scene in file `path`, without its bodies (as a run chooses its tier), at the
/// scene's own grid: the speeds come from its flow.
/// Refuses and fails as measure() does.
SceneRegime scene_regime(const std::string& path);

}  // namespace colloid
