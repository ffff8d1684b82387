// The longest sub-step.                                                   MODEL (T-D8)
#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "tiers/transient/dem_bonds.h"
#include "tiers/transient/dem_surface_force.h"

namespace colloid {

namespace {

constexpr double kNeighbours = 12.0;   // a sphere touches at most, of its own size
constexpr double kUsualStep = 5e-8;    // [s] verified against Hertz at 70 MPa, where it
constexpr double kAdvisedPart = 0.36;  // is this part of the limit

}  // namespace

double DemStepLimits::largest() const {
  return std::min({rayleigh, bonds, surface_forces});
}

const char* DemStepLimits::what() const {
  if (rayleigh <= std::min(bonds, surface_forces)) {
    return "the Rayleigh time of a colloid";
  }
  return bonds <= surface_forces ? "the stiffness of bonds"
                                 : "the steepest surface force";
}

DemStepLimits step_limits(const DemOptions& options) {
  const double a = options.radius;
  const double nu = options.colloid.poisson_ratio;
  const double shear = options.colloid.young_modulus / (2.0 * (1.0 + nu));
  const double mass = options.density * 4.0 / 3.0 * kPi * a * a * a;
  DemStepLimits limits;
  limits.rayleigh = kPi * a * std::sqrt(options.density / shear) / (0.1631 * nu + 0.8766);
  // Leapfrog is stable for w dt < 2; a spring of stiffness k between two masses has
  // w^2 = 2k/m, and with z springs on each colloid (Gershgorin) w^2 <= 2 z k/m.
  const auto limit = [&](double stiffness) {
    return stiffness > 0.0 ? 2.0 / std::sqrt(2.0 * kNeighbours * stiffness / mass)
                           : HUGE_VAL;
  };
  limits.bonds =
      options.surfaces.rules.colloids_attach ? longest_bond_step(options) : HUGE_VAL;
  limits.surface_forces = HUGE_VAL;
  if (options.long_range_forces) {
    for (const PairContact* contact :
         {&options.surfaces.grain, &options.surfaces.wall, &options.surfaces.colloid}) {
      const DemSurfaceForce force(*contact, options.least_surface_force, false);
      limits.surface_forces = std::min(limits.surface_forces, limit(force.steepest()));
    }
  }
  return limits;
}

double advised_step(const DemOptions& options) {
  return std::min(kUsualStep, kAdvisedPart * step_limits(options).largest());
}

}  // namespace colloid
