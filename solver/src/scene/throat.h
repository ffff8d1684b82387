// The reference geometry: a throat between four collectors.
#pragma once

#include "scene/scene.h"

namespace colloid {

/// Box, faces and spheres of the preset `throat`.
///
/// A box d_c wide; four spheres of diameter d_c centred on its vertical edges at z =
/// d_c/2, so that they touch each other and the outlet z- is their lower tangent plane.
/// Flow goes down from the inlet z+; the side faces are walls.  The hole between the
/// collectors passes a sphere of (sqrt 2 - 1) d_c.  Height 1.5 d_c unless given.
void place_throat(Geometry& geometry);

}  // namespace colloid
