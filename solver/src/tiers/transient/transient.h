// The tier transient: Navier-Stokes flow on an octree around resolved colloids, which
// move as soft spheres.
#pragma once

#include <optional>

#include "io/realisation.h"
#include "scene/scene.h"
#include "tiers/run_options.h"

namespace colloid {

/// On every rank; all of them return the same.
std::optional<Realisation> run_transient(const Scene& scene, const RunOptions& options);

}  // namespace colloid
