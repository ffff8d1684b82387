// What the flow does at each face of the box.
#pragma once

#include <array>

#include "core/box.h"

namespace colloid {

/// Condition of the flow at one face of the box, grid units.
struct FlowFace {
  enum class Kind {
    velocity,  ///< velocity given: walls, velocity inlets, a moving lid
    pressure,  ///< pressure given, no viscous traction: outlets, pressure inlets
    symmetry,  ///< no flow through, no shear
    periodic
  };
  Kind kind = Kind::velocity;
  Vec3 velocity;          ///< of a velocity face
  double pressure = 0.0;  ///< of a pressure face
};

using FlowFaces = std::array<FlowFace, kFaces>;

}  // namespace colloid
