// Forces of the fluid on each sphere and on each face of the box.
#pragma once

#include <array>
#include <vector>

#include "flow/stokes_solver.h"

namespace colloid {

/// Forces on all surfaces, from the momentum that the flow leaves in the cut rows.
///
/// Over the control volume V of every velocity unknown, solid part included, the regular
/// seven-point balance
///
///     F = V f - V grad p + mu sum_links A (u_nb - u)/D                        MODEL
///     (F16)
///
/// is zero away from surfaces; what it leaves near one is the force on that surface.  The
/// sums telescope, so all forces together equal the drive to the accuracy of the solve,
/// and the force on a sphere is a control-volume balance around it, second order in the
/// grid spacing (it shares rows with a neighbour nearer than about two cells).  Torques
/// are the moments of the same rows about the sphere's centre.
///
/// A body force stands for a pressure gradient: the part of it that acts in the volume of
/// a sphere is counted as force on the sphere, as the gradient would be.
struct WallForces {
  std::vector<Wrench> spheres;     ///< in the order of the problem's spheres [N, N m]
  std::array<Vec3, kFaces> faces;  ///< on the faces of the box [N]
};

WallForces wall_forces(const StokesSolver& solver);

}  // namespace colloid
