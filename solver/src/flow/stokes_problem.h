// What the flow solver is asked: a box, spheres, a fluid, a drive.  SI.
#pragma once

#include <array>
#include <vector>

#include "core/box.h"

namespace colloid {

/// What moves the fluid.
struct FlowDrive {
  enum class Kind {
    none,
    inlet_velocity,  ///< uniform velocity into the box at inlet faces
    pressure_drop,   ///< inlet pressure minus outlet pressure
    body_force,      ///< force per volume, everywhere in the box
    mean_velocity,   ///< superficial velocity held along the periodic axes
    shear_rate       ///< wall z+ moves along x at shear rate x height
  };
  Kind kind = Kind::none;
  double inlet_velocity = 0.0;  ///< [m/s]
  double pressure_drop = 0.0;   ///< [Pa]
  Vec3 body_force;              ///< [N/m^3]
  Vec3 mean_velocity;           ///< [m/s]
  double shear_rate = 0.0;      ///< [1/s]
};

struct StokesProblem {
  Box box;
  std::vector<Sphere> spheres;  ///< fixed, no slip; may overlap, touch, leave the box
  double viscosity = 1e-3;      ///< [Pa s]
  FlowDrive drive;
  std::array<int, 3> cells{};
};

/// Axis along which the flow is driven: the inlet's, or the largest component of the
/// force or mean velocity; -1 for none.
int flow_axis(const StokesProblem& problem);

struct StokesOptions {
  /// Residual relative to the drive or the forces by pressure, whichever are larger:
  /// 2-norms of scaled rows.
  double tolerance = 1e-6;
  int max_iterations = 200;  ///< then the flow has not converged
  int threads = 1;           ///< results do not depend on it
};

/// What a solve cost.
struct StokesStatistics {
  bool converged = false;
  int iterations = 0;
  double relative_residual = 0.0;
  double work_units = 0.0;     ///< solve time over the time of one residual evaluation
  double seconds = 0.0;        ///< of the solve
  double setup_seconds = 0.0;  ///< rows, coarse levels
  double residual_ns_per_cell = 0.0;
  int subgrid_openings = 0;  ///< throats below the grid, opened by their conductance
};

/// Force and torque of the fluid on a surface, torque about the sphere's centre.
struct Wrench {
  Vec3 force;   ///< [N]
  Vec3 torque;  ///< [N m]
};

}  // namespace colloid
