#include "tiers/transient/transient.h"

#include "core/error.h"
#include "tiers/transient/transient_loop.h"

namespace colloid {

std::optional<Realisation> run_transient(const Scene& scene, const RunOptions& options) {
  require(scene.colloids.has_value(), "/colloids",
          "is missing; expected the colloids to follow");
  return TransientLoop(scene, options).run();
}

}  // namespace colloid
