// Incompressible flow around rigid spheres, fixed, driven or free, in time. MODEL section
// T
//
// OpenFOAM's finite volumes on the octree grid.  The motion of free bodies is part of the
// same linear systems as the fluid's: nothing is exchanged from step to step, so no ratio
// of densities and no length of step makes the coupling unstable.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/box.h"
#include "scene/scene.h"

namespace colloid {

/// A sphere in the flow besides the scene's grains.
struct FlowBody {
  Sphere sphere;
  bool free = false;    ///< its motion is found; otherwise `velocity` and `spin` are kept
  double mass = 0.0;    ///< [kg]; of a free body
  Vec3 velocity, spin;  ///< at the beginning of the step [m/s, rad/s]
  /// On a free body, everything that is not the flow's: weight less buoyancy, surface
  /// forces, contacts [N, N m].
  Vec3 force, torque;
};

/// The body half a step of `dt` on its way, where a step that takes it along should see
/// it: the velocity found belongs to the middle of the way (MODEL, below T7).
inline FlowBody halfway(FlowBody body, double dt) {
  body.sphere.center += (0.5 * dt) * body.velocity;
  return body;
}

/// Of one body, at the end of a step.
struct FlowResponse {
  Vec3 velocity, spin;  ///< [m/s, rad/s]
  Vec3 force, torque;   ///< the flow's on the body, without buoyancy [N, N m]
};

struct TransientFlowOptions {
  std::array<int, 3> cells{};        ///< of the base grid, along each axis
  int refinement = 1;                ///< halvings of the cell at bodies
  int wall_refinement = 0;           ///< halvings at the surfaces of grains
  int outer_iterations = 1;          ///< of momentum and pressure, a step
  double momentum_tolerance = 3e-3;  ///< residual of the momentum over that at first
  double pressure_tolerance = 1e-2;  ///< residual of the pressure over that at first
  /// Rate at which the liquid inside a body follows it, over nu/h^2 + 1/dt.  What leaks
  /// is its reciprocal.
  double rigidity = 1e3;
};

struct TransientFlowCounts {
  long cells = 0;  ///< now
  long steps = 0;
  long grids = 0;  ///< built so far
  long momentum_iterations = 0;
  long pressure_iterations = 0;
};

class TransientFlow {
 public:
  /// At rest.  Drives: inlet velocity, pressure drop, body force, shear rate; InputError
  /// for another.  The scene is referred to, not copied.
  TransientFlow(const Scene& scene, const TransientFlowOptions& options);
  TransientFlow(Scene&& scene, const TransientFlowOptions& options) = delete;
  ~TransientFlow();
  TransientFlow(const TransientFlow&) = delete;
  TransientFlow& operator=(const TransientFlow&) = delete;

  /// Over `dt` [s] with the bodies where they are.  Builds the grid anew first where a
  /// body has left its refined neighbourhood.  ConvergenceError if it becomes unstable.
  std::vector<FlowResponse> step(double dt, const std::vector<FlowBody>& bodies);

  /// Until the velocity changes by less than `change`, relative, over `dt`; at most
  /// `steps`.  Bodies do not move from their places.  Returns the steps taken.
  int settle(double dt, double change, int steps, const std::vector<FlowBody>& bodies);

  /// The step at which the largest Courant number is one [s]; infinite at rest.
  double courant_time() const;

  double pressure_drop() const;           ///< inlet minus outlet [Pa]
  double flow_rate() const;               ///< through the inlet, into the box [m^3/s]
  Vec3 mean_velocity() const;             ///< over the whole box, solids included [m/s]
  Vec3 velocity_at(const Vec3& x) const;  ///< of the cell there [m/s]
  /// The flow's on all grains together, in the last step; a body force acts inside
  /// grains too and is part of it [N].
  Vec3 grain_force() const;
  /// What the outside does to the liquid through a face of the box, in the last step:
  /// tractions, and momentum that flows in; none through periodic ones [N].
  Vec3 face_force(int face) const;
  /// Rate of change of the momentum of the liquid in the last step, that in the place of
  /// free bodies included, of held ones not [N].
  Vec3 liquid_inertia() const;
  double cell_at_bodies() const;  ///< shortest edge [m]
  const TransientFlowCounts& counts() const;

  /// All that the next step depends on.
  void save(std::map<std::string, std::vector<double>>& reals,
            std::map<std::string, std::vector<std::int64_t>>& integers) const;
  void restore(const std::map<std::string, std::vector<double>>& reals,
               const std::map<std::string, std::vector<std::int64_t>>& integers);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace colloid
