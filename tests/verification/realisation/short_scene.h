// The reference scene, shortened.
#pragma once

#include "scene/read_scene.h"
#include "tiers/one_way.h"

namespace colloid {

// Four times the reference's concentration on a coarser grid: much happens soon.
inline Scene short_scene() {
  Scene scene = read_scene(PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json").scene;
  scene.duration = 0.6;
  scene.colloids->volume_fraction = 0.02;
  scene.fidelity.cells_per_colloid = 2.5;
  scene.fidelity.capture_gap = 200e-9;  // many are retained
  return scene;
}

inline Realisation run(const Scene& scene, const RunOptions& options) {
  return run_one_way(scene, options).value();
}

}  // namespace colloid
