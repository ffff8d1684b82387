// The tier one_way: the flow carries the colloids, only the deposit acts on the flow.
#pragma once

#include <optional>

#include "io/realisation.h"
#include "scene/scene.h"
#include "tiers/run_options.h"

namespace colloid {

/// One realisation; nothing if it was interrupted, with a checkpoint written.
///
/// Refuses (InputError) a scene without colloids, inlet or drive, with free bodies, or
/// one whose clean flow is outside the tier's range; throws ConvergenceError where the
/// flow does not converge or a colloid's motion becomes unstable.
std::optional<Realisation> run_one_way(const Scene& scene, const RunOptions& options);

}  // namespace colloid
