// Spheres in a grid that does not follow them: in which cells their rigid motion is
// imposed, and how strongly.                                             MODEL section T
//
// A cell whose centre is inside a body moves with it.  A cell outside of which a
// neighbour's centre is inside feels the surface where it is: the viscous flux of a link
// that the surface cuts at the fraction theta of its length is nu (u - V)/(theta h)
// rather than nu (u - V_nb)/h (Shortley & Weller 1938).  As V is rigid, hence linear in
// space, the difference is a drag on that cell alone, towards the body's motion at the
// cell's centre:
//
//     (T2)  lambda = (nu/h^2) sum over cut links of (1/theta - 1)
//
// It goes to infinity where the centre reaches the surface, so that nothing jumps when a
// body moves through the grid.
//
// Where a body is about to touch a wall or another body the cells between them cannot be
// rigid: the liquid there would have no way out but through the walls of the cells, at a
// resistance that is set by the penalisation and jumps with every cell that goes inside.
// They stay liquid, with a resistance of about that of a gap of half a cell; the rest is
// sub-grid lubrication's.
#pragma once

#include <vector>

#include "core/box.h"
#include "tiers/transient/octree.h"

namespace colloid {

/// The motion of body `body` acts on cell `cell`.
struct ImmersedEntry {
  int cell = 0;
  int body = 0;
  double strength = 0.0;  ///< lambda, a rate [1/s]
  bool solid = false;     ///< the cell's centre is inside
  Vec3 arm;               ///< from the body's centre (nearest image) to the cell's [m]
};

/// Entries of all bodies, by body, then by cell, those inside without the 1/dt.
/// `viscosity`: kinematic [m^2/s].  `rigidity`: the rate at which cells inside a body
/// follow it, and the largest contribution of a link, over nu/h^2.
std::vector<ImmersedEntry> immerse(const OctreeLevels& levels, const OctreeMesh& mesh,
                                   const std::vector<Sphere>& bodies, double viscosity,
                                   double rigidity);

/// Keeps cells liquid where body `body` of `entries` is about to touch a wall or one of
/// `spheres`, itself apart.
void open_narrow_gaps(const OctreeLevels& levels, const OctreeMesh& mesh, int body,
                      const std::vector<Sphere>& spheres, double viscosity,
                      std::vector<ImmersedEntry>& entries);

}  // namespace colloid
