#include "commands/scene_regime.h"

#include "scene/read_scene.h"

namespace colloid {

SceneRegime scene_regime(const std::string& path) {
  const Scene scene = read_scene(path).scene;
  SceneRegime out{clean_regime(scene, 1), {scene.fidelity.tier, "asked for"}, {}};
  if (scene.fidelity.tier == TierChoice::automatic) {
    out.tier = advise_tier(scene, out.regime);
  }
  if (out.tier.choice == TierChoice::transient && scene.colloids) {
    out.cost = predict_transient_cost(scene, out.regime);
  }
  return out;
}

}  // namespace colloid
