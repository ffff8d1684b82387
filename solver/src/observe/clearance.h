// How far a point is from the nearest surface.
#pragma once

#include <vector>

#include "core/box.h"
#include "observe/surface.h"

namespace colloid {

struct Clearance {
  double distance = 0.0;  ///< to the nearest surface [m]; negative inside a sphere or
                          ///< beyond a wall; infinite where there is no surface
  SurfaceName nearest;    ///< index -1 where there is no surface
};

/// Distance from a point to the nearest sphere or wall face, with periodic images. Inlet,
/// outlet and symmetry faces are no surfaces.  The point may lie outside the box.
Clearance clearance(const Box& box, const std::vector<Sphere>& spheres,
                    const Vec3& point);

}  // namespace colloid
