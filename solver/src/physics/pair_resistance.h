// Hydrodynamic resistance of two rigid spheres of any radii in an unbounded liquid, at
// every gap: the functions of Jeffrey & Onishi (1984), J. Fluid Mech. 139, 261 ("JO").
//
// Spheres 1 and 2 of radii a_1, a_2, d = unit vector from 1 to 2, centres r apart,
// xi = 2r/(a_1 + a_2) - 2 = gap over mean radius.  MODEL (R7), for alpha, beta = 1, 2 and
// P = dd:
//
//     F_alpha = -mu sum_beta [ 3 pi (a_alpha + a_beta)   (xa P + ya (I - P)) U_beta
//                              + pi (a_alpha + a_beta)^2 yb_(beta alpha) d x omega_beta ]
//     T_alpha = -mu sum_beta [   pi (a_alpha + a_beta)^2 yb_(alpha beta) U_beta x d
//                              + pi (a_alpha + a_beta)^3 (xc P + yc (I - P)) omega_beta ]
//
// In the bulk xa11 = ya11 = xc11 = yc11 = 1 (6 pi mu a, 8 pi mu a^3) and all couplings
// vanish. xa21 = xa12 etc. by reciprocity.  At contact (xi -> 0) xa ~ g_1/xi and the
// others grow like ln(1/xi), except xc, which stays finite.
//
// One smooth expression per function and ratio, MODEL (R8): the lubrication terms of JO
// plus a polynomial in (2/s)^2 made from their series when the object is built.  Largest
// error, relative to the function or, where that is below 1, absolute: 3e-5 for equal
// spheres, 1e-4 for ratios from 0.1 to 10; at 20, 1e-3 in xc of the smaller sphere and
// 2e-4 in the others.
#pragma once

#include <array>

namespace colloid {

struct PairResistance {
  double xa11, xa12, xa22;        ///< along d: force of translation
  double ya11, ya12, ya22;        ///< across d: force of translation
  double yb11, yb12, yb21, yb22;  ///< across d: torque of translation
  double xc11, xc12, xc22;        ///< about d: torque of rotation
  double yc11, yc12, yc22;        ///< about an axis across d: torque of rotation
};

class TwoSphereResistance {
 public:
  /// `ratio` = lambda = a_2 / a_1, from 0.05 to 20 (beyond: the wall of
  /// wall_resistance.h). The first object of a process takes a third of a second, others
  /// a millisecond.
  explicit TwoSphereResistance(double ratio);

  /// `gap` = xi = 2h / (a_1 + a_2) > 0; infinity gives the bulk.  About 0.2 microseconds.
  PairResistance at(double gap) const;

  static constexpr int kFunctions = 16;
  static constexpr int kDegree = 20;

 private:
  using Row = std::array<double, kFunctions>;  // even in 2/s first, see the source

  Row pole_{};  // of 1/(1 - u^2), u = 2/s
  std::array<Row, 3> log_{};
  std::array<Row, kDegree + 1> polynomial_{};  // powers of 2u^2 - 1
};

}  // namespace colloid
