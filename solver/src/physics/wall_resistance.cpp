#include "physics/wall_resistance.h"

#include <cassert>
#include <cmath>

#include "physics/wall_resistance_coefficients.h"

namespace colloid {

WallResistance wall_resistance(double gap_over_radius) {
  assert(gap_over_radius > 0.0);
  const double eps = gap_over_radius;
  const double x = 1.0 / (1.0 + eps);  // a over the centre's height
  const double y = std::isinf(eps) ? 1.0 : eps * x;
  const double log = -std::log(y);
  const double t = 2.0 * x - 1.0;

  // All functions at once, even and odd powers of t apart: no step waits for another, and
  // the inner loops are vectorised.
  static_assert(kWallDegree % 2 == 0, "the even powers close the sum");
  const double t2 = t * t;
  double even[kWallFunctions];
  double odd[kWallFunctions];
  for (int i = 0; i < kWallFunctions; ++i) {
    even[i] = kWallPolynomial[kWallDegree][i] * t2 + kWallPolynomial[kWallDegree - 2][i];
    odd[i] = kWallPolynomial[kWallDegree - 1][i];
  }
  for (int power = kWallDegree - 4; power >= 0; power -= 2) {
    for (int i = 0; i < kWallFunctions; ++i) {
      even[i] = even[i] * t2 + kWallPolynomial[power][i];
      odd[i] = odd[i] * t2 + kWallPolynomial[power + 1][i];
    }
  }
  double f[kWallFunctions];
  for (int i = 0; i < kWallFunctions; ++i) {
    f[i] = even[i] + t * odd[i] +
           log * (kWallLog0[i] + y * (kWallLog1[i] + y * kWallLog2[i]));
  }

  const double x4 = (x * x) * (x * x);
  return {1.0 / eps + f[0], f[1], x4 * f[2], f[3], f[4], f[5], f[6], f[7]};
}

FreeMotion free_in_shear(double gap_over_radius) {
  const WallResistance r = wall_resistance(gap_over_radius);
  const double inverse_height = 1.0 / (1.0 + gap_over_radius);  // a/(a + h)
  // (R1) without force and torque, U in units of S (a + h) and omega of S/2:
  //   f_t speed - (2/3) t_t (a/(a+h)) spin          = f_s
  //  -2 t_t ((a+h)/a) speed + t_r spin              = t_s
  const double force_by_spin = 2.0 / 3.0 * r.t_t * inverse_height;
  const double torque_by_speed = r.t_t / inverse_height * 2.0;
  if (std::isinf(gap_over_radius)) {
    return {};
  }
  const double determinant = r.f_t * r.t_r - force_by_spin * torque_by_speed;
  return {(r.f_s * r.t_r + force_by_spin * r.t_s) / determinant,
          (r.t_s * r.f_t + torque_by_speed * r.f_s) / determinant};
}

}  // namespace colloid
