// Relative motion of two equal spheres, free of force and torque, in a linear flow.
//
// Centres r = r n apart, radius a, s = r/a, xi = s - 2; ambient flow omega x x + E.x.
// Batchelor & Green (1972), J. Fluid Mech. 56, 375, MODEL (R11):
//
//     V = omega x r + E.r - [ A nn + B (I - nn) ].E.r
//
// Both vanish far away: A ~ 5/s^3 - 8/s^5 + 25/s^6, B ~ 16/(3 s^5); at contact A ~ 1 -
// 4.077 xi and B ~ 0.4058 - 0.95/ln(1/xi).  From the forces on two spheres held in the
// flow (two_sphere_series.h) and pair_resistance.h.  Largest error: 3e-8 of 1 - A; of B
// 1e-7 from xi = 0.1, 2e-6 at 0.05, 1e-4 at contact.
#pragma once

#include "physics/chebyshev.h"
#include "physics/pair_resistance.h"

namespace colloid {

struct StrainHindrance {
  double a = 0.0;  ///< A, of the motion along the line of centres
  double b = 0.0;  ///< B, of the motion across it
};

class PairInStrain {
 public:
  PairInStrain();

  /// `gap` = xi > 0, in radii; infinity gives 0.
  StrainHindrance at(double gap) const;

 private:
  TwoSphereResistance resistance_;
  ChebyshevSeries<3> held_;  // force along, force across, torque against u = 2/s
};

}  // namespace colloid
