#include "physics/born_repulsion.h"

#include <cmath>

namespace colloid {

namespace {

// (sigma/x)^n / 7560 with the powers taken of a ratio, so that no intermediate
// underflows.
double ratio_power(double sigma, double x, int n) {
  return std::pow(sigma / x, n) / 7560.0;
}

}  // namespace

double born_plate_energy(double hamaker, double sigma, double radius, double gap) {
  const double far_side = 2.0 * radius + gap;
  return std::abs(hamaker) *
         (ratio_power(sigma, far_side, 6) * ((8.0 * radius + gap) / far_side) +
          ratio_power(sigma, gap, 6) * ((6.0 * radius - gap) / gap));
}

double born_plate_force(double hamaker, double sigma, double radius, double gap) {
  const double far_side = 2.0 * radius + gap;
  return 6.0 * std::abs(hamaker) *
         (ratio_power(sigma, far_side, 6) * ((9.0 * radius + gap) / far_side) / far_side +
          ratio_power(sigma, gap, 6) * ((7.0 * radius - gap) / gap) / gap);
}

double born_spheres_energy(double hamaker, double sigma, double derjaguin_radius,
                           double gap) {
  return 0.5 * born_plate_energy(hamaker, sigma, 2.0 * derjaguin_radius, gap);
}

double born_spheres_force(double hamaker, double sigma, double derjaguin_radius,
                          double gap) {
  return 0.5 * born_plate_force(hamaker, sigma, 2.0 * derjaguin_radius, gap);
}

}  // namespace colloid
