// Hydrodynamic resistance of a sphere near a plane no-slip wall, at every gap.
//
// Sphere of radius a, gap h, eps = h/a, wall below it (z = 0), the rest of the liquid at
// rest or in the shear u_x = S z.  The sphere moves with U and turns with omega; positive
// omega_y is the sense of rolling for U_x > 0.  Stokes flow, MODEL (R1):
//
//     F_z = -6 pi mu a U_z f_n
//     F_x = -6 pi mu a U_x f_t + 8 pi mu a^2 omega_y t_t + 6 pi mu a (a + h) S f_s
//     T_y = +8 pi mu a^2 U_x t_t - 8 pi mu a^3 omega_y t_r + 4 pi mu a^3 S t_s
//     T_z = -8 pi mu a^3 omega_z t_n
//
// and, held in the stagnation flow u_z = -A z^2, u_r = A r z at the height H = a + h,
//
//     F_z = -6 pi mu a A (H^2 + a^2/3) f_e
//
// where A (H^2 + a^2/3) is its Faxen velocity u + (a^2/6) lap u.  (Goren & O'Neill, 1971,
// relate the force to u = A H^2 alone: their factor is f_e (1 + x^2/3), x = a/H, 3.23 at
// contact.)
//
// Every factor is 1 in the bulk except the coupling t_t, which vanishes there.  (In the
// notation of Goldman, Cox & Brenner, 1967: f_t = -F_t*, t_t = T_t* = 3/4 F_r*, t_r =
// -T_r*, f_s = F_s*, t_s = T_s*.)
//
// One smooth expression holds from contact to infinity, MODEL (R2): the lubrication terms
// with their exact coefficients plus a polynomial, fitted to the exact series by
// tables/wall_resistance.py.  Largest relative error 4e-6 (t_t) and 2e-7 (the others).
// As eps -> 0: f_n ~ 1/eps, f_t ~ (8/15) ln(1/eps) + 0.95429, t_t ~ (1/10) ln(1/eps) -
// 0.19295, t_r ~ (2/5) ln(1/eps) + 0.37089; f_s = 1.70062, t_s = 0.94399, t_n = 1.20206,
// f_e = 2.42200.
#pragma once

namespace colloid {

struct WallResistance {
  double f_n = 1.0;  ///< force of translation along the normal
  double f_t = 1.0;  ///< force of translation along the wall
  double t_t = 0.0;  ///< torque of translation along the wall = force of rotation
  double t_r = 1.0;  ///< torque of rotation about an axis along the wall
  double f_s = 1.0;  ///< force of a shear flow
  double t_s = 1.0;  ///< torque of a shear flow
  double t_n = 1.0;  ///< torque of rotation about the normal
  double f_e = 1.0;  ///< force of a stagnation flow, over Faxen's
};

/// `gap_over_radius` = h/a > 0; infinity gives the bulk.  About 45 ns.
WallResistance wall_resistance(double gap_over_radius);

/// How a sphere free of force and torque moves in the shear flow, MODEL (R6).
struct FreeMotion {
  double speed = 1.0;  ///< U / (S (a + h)) [-]
  double spin = 1.0;   ///< omega / (S/2) [-]
};

FreeMotion free_in_shear(double gap_over_radius);

}  // namespace colloid
