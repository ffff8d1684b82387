// The tier quasi_steady: every colloid resolved in Stokes flow.            MODEL section
// Q
#pragma once

#include <optional>

#include "io/realisation.h"
#include "scene/scene.h"
#include "tiers/run_options.h"

namespace colloid {

/// One realisation; nothing if it was interrupted.  Refuses what run_one_way() refuses.
std::optional<Realisation> run_quasi_steady(const Scene& scene,
                                            const RunOptions& options);

}  // namespace colloid
