#include "physics/van_der_waals.h"

#include <cmath>

namespace colloid {

namespace {

constexpr double kPlateRetardation = 14.0;    // [-] Gregory (1981), sphere and plate
constexpr double kSpheresRetardation = 5.32;  // [-] Gregory (1981), plates and spheres

/// u of MODEL (S4), 1 - u without cancellation, and -du/dh [1/m].
struct Closeness {
  double u;
  double one_minus_u;
  double slope;
};

Closeness closeness(const Dispersion& pair, double gap) {
  const double diameter = 2.0 * pair.radius;
  const double u_plate = diameter / (gap + diameter);
  if (std::isinf(pair.other_radius)) {
    return {u_plate, gap / (gap + diameter), u_plate / (gap + diameter)};
  }
  const double other = 2.0 * pair.other_radius;
  const double u = u_plate * (other / (gap + other));
  const double one_minus_u =
      gap / (gap + diameter) * ((gap + diameter + other) / (gap + other));
  return {u, one_minus_u, u * (1.0 / (gap + diameter) + 1.0 / (gap + other))};
}

// (u/2)(1 + 1/(1-u)) + ln(1-u) = sum over n >= 3 of (1/2 - 1/n) u^n.  At u = 0.03 the
// closed form has lost five digits and ten terms leave 1e-15 of the sum.
double hamaker_function(const Closeness& c) {
  if (c.u > 0.03) {
    return 0.5 * c.u * (1.0 + 1.0 / c.one_minus_u) + std::log(c.one_minus_u);
  }
  double sum = 0.0;
  for (int n = 12; n >= 3; --n) {
    sum = sum * c.u + (0.5 - 1.0 / n);
  }
  return sum * c.u * c.u * c.u;
}

// 1 - y ln(1 + 1/y) = 1/(2y) - 1/(3y^2) + ...: the series where the two terms cancel.
// At y = 100 eight terms leave 1/(10 y^9) against a cancellation of y times round-off.
double retardation_factor(double y) {
  if (y < 100.0) {
    return 1.0 - y * std::log1p(1.0 / y);
  }
  double sum = 0.0;
  for (int n = 8; n >= 1; --n) {
    sum = 1.0 / (n + 1.0) - sum / y;
  }
  return sum / y;
}

}  // namespace

double unretarded_energy(const Dispersion& pair, double gap) {
  return -pair.hamaker / 6.0 * hamaker_function(closeness(pair, gap));
}

double unretarded_force(const Dispersion& pair, double gap) {
  const Closeness c = closeness(pair, gap);
  const double ratio = c.u / c.one_minus_u;
  return -pair.hamaker / 12.0 * ratio * ratio * c.slope;
}

double retarded_plate_energy(const Dispersion& pair, double gap) {
  const double y = kPlateRetardation * gap / pair.wavelength;
  return unretarded_energy(pair, gap) / (1.0 + y);
}

double retarded_plate_force(const Dispersion& pair, double gap) {
  const double y = kPlateRetardation * gap / pair.wavelength;
  const double slope = -y / (gap * (1.0 + y) * (1.0 + y));
  return unretarded_force(pair, gap) / (1.0 + y) - unretarded_energy(pair, gap) * slope;
}

double retarded_spheres_energy(const Dispersion& pair, double gap) {
  const double y = kSpheresRetardation * gap / pair.wavelength;
  return unretarded_energy(pair, gap) * retardation_factor(y);
}

double retarded_spheres_force(const Dispersion& pair, double gap) {
  const double y = kSpheresRetardation * gap / pair.wavelength;
  const double r = retardation_factor(y);
  const double slope = (r - 1.0 / (1.0 + y)) / gap;  // h r' = r - 1/(1 + y)
  return unretarded_force(pair, gap) * r - unretarded_energy(pair, gap) * slope;
}

}  // namespace colloid
