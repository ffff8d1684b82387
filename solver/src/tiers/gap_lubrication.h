// Lubrication below the grid between the bodies of a scene and what is near them.  MODEL
// (Q2)
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/box.h"
#include "scene/scene.h"

namespace colloid {

/// Wrenches besides the resolved flow's: drive - resistance V, V of 6 n: per body (U, w).
/// SI.
struct GapLubrication {
  Eigen::MatrixXd resistance;
  Eigen::VectorXd drive;  ///< by a wall that moves
};

/// `fixed`: grains and deposit; `cell`: the grid's width [m].  Gaps below 0.158 nm count
/// as that.  Refuses surfaces in reach that are narrower than a twentieth of a body, and
/// bodies in reach of each other of which one is.
GapLubrication gap_lubrication(const Scene& scene, const std::vector<Sphere>& fixed,
                               double cell);

}  // namespace colloid
