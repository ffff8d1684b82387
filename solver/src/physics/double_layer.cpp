#include "physics/double_layer.h"

#include <cmath>

#include "core/constants.h"

namespace colloid {

namespace {

double squared(double x) {
  return x * x;
}

}  // namespace

double constant_potential_energy(const DoubleLayerTerm& pair, double gap) {
  const double kappa_h = gap / pair.debye_length;
  const double x = std::exp(-kappa_h);
  const double one_minus_x = -std::expm1(-kappa_h);
  // ln(1 - x): through expm1 where x is near 1, through log1p where x is small.
  const double log_one_minus_x = x > 0.5 ? std::log(one_minus_x) : std::log1p(-x);
  return kPi * pair.permittivity * pair.radius *
         (squared(pair.potential_1 + pair.potential_2) * std::log1p(x) +
          squared(pair.potential_1 - pair.potential_2) * log_one_minus_x);
}

double constant_potential_force(const DoubleLayerTerm& pair, double gap) {
  const double kappa_h = gap / pair.debye_length;
  const double x = std::exp(-kappa_h);
  const double one_minus_x = -std::expm1(-kappa_h);
  return kPi * pair.permittivity * pair.radius / pair.debye_length * x *
         (squared(pair.potential_1 + pair.potential_2) / (1.0 + x) -
          squared(pair.potential_1 - pair.potential_2) / one_minus_x);
}

double superposition_energy(const DoubleLayerTerm& pair, double gap) {
  return 4.0 * kPi * pair.permittivity * pair.radius * pair.potential_1 *
         pair.potential_2 * std::exp(-gap / pair.debye_length);
}

double superposition_force(const DoubleLayerTerm& pair, double gap) {
  return superposition_energy(pair, gap) / pair.debye_length;
}

}  // namespace colloid
