// The velocity of the fluid at a point.
#pragma once

#include "flow/stokes_solver.h"

namespace colloid {

/// Velocity at x [m], in m/s; inside spheres theirs, given values on the box.
///
/// Away from spheres trilinear in each component.  Near a sphere the face values are the
/// shear times an effective wall distance (wall_rows.h); there the shear is interpolated
/// and multiplied by the true distance, so the velocity on the surface is the surface's.
/// Second order; x outside the box is taken to its nearest point, or around a periodic
/// axis.
Vec3 velocity_at(const StokesSolver& solver, const Vec3& x);

}  // namespace colloid
