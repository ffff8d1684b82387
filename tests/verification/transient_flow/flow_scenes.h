// Scenes that the cases of this folder share.
#pragma once

#include <cmath>

#include "core/constants.h"
#include "scene/scene.h"
#include "tiers/transient/transient_flow.h"

namespace colloid {

constexpr FaceCondition kPeriodic = FaceCondition::periodic;
constexpr FaceCondition kWall = FaceCondition::wall;

/// A free sphere; `force` besides the flow's [N].
inline FlowBody free_sphere(const Vec3& centre, double radius, double density,
                            const Vec3& force = {}) {
  FlowBody body;
  body.sphere = {centre, radius};
  body.free = true;
  body.mass = 4.0 / 3.0 * kPi * radius * radius * radius * density;
  body.force = force;
  return body;
}

/// The reference throat at U [m/s]; a, d_c as there.
inline Scene throat_scene(double inlet_velocity) {
  constexpr double kDiameter = 96.6e-6;
  Scene scene;
  scene.geometry.box = {
      {kDiameter, kDiameter, 1.5 * kDiameter},
      {kWall, kWall, kWall, kWall, FaceCondition::outlet, FaceCondition::inlet}};
  for (int corner = 0; corner < 4; ++corner) {
    scene.geometry.spheres.push_back(
        {{corner % 2 * kDiameter, corner / 2 * kDiameter, 0.5 * kDiameter},
         0.5 * kDiameter});
  }
  scene.drive.inlet_velocity = inlet_velocity;
  return scene;
}

inline TransientFlowOptions base_cells(int nx, int ny, int nz, int refinement) {
  TransientFlowOptions options;
  options.cells = {nx, ny, nz};
  options.refinement = refinement;
  return options;
}

}  // namespace colloid
