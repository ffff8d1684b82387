// What the keys of a scene must satisfy together.
#pragma once

#include "scene/scene.h"

namespace colloid {

/// Refuses a scene that contradicts itself; `where` of the InputError is the JSON pointer
/// of the value to change.  Expects the box and all spheres to be in place.
void check_scene(const Scene& scene);

}  // namespace colloid
