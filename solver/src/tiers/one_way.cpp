#include "tiers/one_way.h"

#include "tiers/inertia_free.h"

namespace colloid {

std::optional<Realisation> run_one_way(const Scene& scene, const RunOptions& options) {
  InertiaFreeScene ready(scene, options, "one_way");
  const Hindrance hindrance = scene.fidelity.hindrance;
  OneWayMotion model(ready.motion_options(hindrance != Hindrance::none,
                                          hindrance == Hindrance::wall_and_pair),
                     ready.flow, ready.surfaces, ready.grain_radii);
  return TimeLoop(scene, options, ready.loop_parts(options, model)).run();
}

}  // namespace colloid
