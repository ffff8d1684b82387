// The flux of a linear near-wall profile through one grid face.
#pragma once

namespace colloid {

/// Mean of the positive part of the distance to a plane over a rectangle, same unit as d.
///
///     M = (1/A) int_A max(0, d + g1 s + g2 t) ds dt,     -1/2 <= s, t <= 1/2   MODEL
///     (F7)
///
/// d is the signed distance of the rectangle's centre from the plane, g1 and g2 the
/// change of that distance across the two sides.  Near a no-slip wall a tangential
/// velocity grows like the distance, so M times the shear is the exact flux per area
/// through a face which the wall cuts.  M = d for a face that the plane does not touch, 0
/// for one behind it.
double wall_moment(double d, double g1, double g2);

}  // namespace colloid
