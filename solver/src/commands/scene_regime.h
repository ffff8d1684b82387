// What `describe --regime` shows, found by measuring the scene.  Apart from describe.cpp,
// because the scene's list of keys and the flow's unknowns are both named Fields.
#pragma once

#include <string>

#include "tiers/regime.h"

namespace colloid {

/// The regime of the scene in file `path`, at the scene's own grid: the speeds come from
/// its flow.  Refuses and fails as measure() does.
Regime scene_regime(const std::string& path);

}  // namespace colloid
