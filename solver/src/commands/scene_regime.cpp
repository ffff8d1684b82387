#include "commands/scene_regime.h"

#include "scene/read_scene.h"
#include "tiers/measurement.h"

namespace colloid {

Regime scene_regime(const std::string& path) {
  const SceneFile file = read_scene(path);
  return measure(file.scene, {}).regime;
}

}  // namespace colloid
