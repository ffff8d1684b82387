#include "physics/electrolyte.h"

#include <cmath>

#include "core/constants.h"

namespace colloid {

double thermal_energy(double temperature) {
  return kBoltzmann * temperature;
}

double permittivity(const Electrolyte& electrolyte) {
  return electrolyte.relative_permittivity * kVacuumPermittivity;
}

double debye_length(const Electrolyte& electrolyte) {
  const double charge_density_scale = 2.0 * kAvogadro * kElementaryCharge *
                                      kElementaryCharge * electrolyte.ionic_strength;
  return std::sqrt(permittivity(electrolyte) * thermal_energy(electrolyte.temperature) /
                   charge_density_scale);
}

}  // namespace colloid
