#include "physics/surface_pair.h"

#include <cmath>
#include <limits>

#include "core/error.h"
#include "physics/born_repulsion.h"

namespace colloid {

namespace {

bool positive(double x) {
  return std::isfinite(x) && x > 0.0;
}

SurfacePair checked(const SurfacePair& pair) {
  const char* where = "/surface";
  require(positive(pair.radius), where, "a radius must be positive");
  require(pair.shape == PairShape::sphere_plate || positive(pair.other_radius), where,
          "a radius must be positive");
  require(std::isfinite(pair.zeta) && std::isfinite(pair.other_zeta), where,
          "a zeta potential is not a number");
  require(std::isfinite(pair.hamaker), where, "the Hamaker constant is not a number");
  require(std::isfinite(pair.born_diameter) && pair.born_diameter >= 0.0, where,
          "the Born diameter is negative");
  require(positive(pair.closest_gap), where, "the closest gap must be positive");
  require(positive(pair.wavelength), where, "the wavelength must be positive");
  require(positive(pair.electrolyte.ionic_strength), where,
          "the ionic strength must be positive: at zero the Debye length is infinite");
  require(positive(pair.electrolyte.relative_permittivity), where,
          "the relative permittivity must be positive");
  require(positive(pair.electrolyte.temperature), where,
          "the temperature must be positive");
  return pair;
}

double derjaguin_radius_of(const SurfacePair& pair) {
  if (pair.shape == PairShape::sphere_plate) {
    return pair.radius;
  }
  return pair.radius * (pair.other_radius / (pair.radius + pair.other_radius));
}

}  // namespace

SurfaceForces::SurfaceForces(const SurfacePair& pair)
    : pair_(checked(pair)),
      double_layer_{derjaguin_radius_of(pair), pair.zeta, pair.other_zeta,
                    permittivity(pair.electrolyte),
                    colloid::debye_length(pair.electrolyte)},
      dispersion_{pair.hamaker, pair.radius,
                  pair.shape == PairShape::sphere_plate
                      ? std::numeric_limits<double>::infinity()
                      : pair.other_radius,
                  pair.wavelength},
      thermal_energy_(colloid::thermal_energy(pair.electrolyte.temperature)) {}

double SurfaceForces::energy(double gap) const {
  return double_layer_energy(gap) + van_der_waals_energy(gap) + born_energy(gap);
}

double SurfaceForces::force(double gap) const {
  return double_layer_force(gap) + van_der_waals_force(gap) + born_force(gap);
}

double SurfaceForces::double_layer_energy(double gap) const {
  return pair_.double_layer == DoubleLayerForm::constant_potential
             ? constant_potential_energy(double_layer_, gap)
             : superposition_energy(double_layer_, gap);
}

double SurfaceForces::double_layer_force(double gap) const {
  return pair_.double_layer == DoubleLayerForm::constant_potential
             ? constant_potential_force(double_layer_, gap)
             : superposition_force(double_layer_, gap);
}

double SurfaceForces::van_der_waals_energy(double gap) const {
  if (pair_.van_der_waals == VanDerWaalsForm::unretarded) {
    return unretarded_energy(dispersion_, gap);
  }
  return pair_.shape == PairShape::sphere_plate
             ? retarded_plate_energy(dispersion_, gap)
             : retarded_spheres_energy(dispersion_, gap);
}

double SurfaceForces::van_der_waals_force(double gap) const {
  if (pair_.van_der_waals == VanDerWaalsForm::unretarded) {
    return unretarded_force(dispersion_, gap);
  }
  return pair_.shape == PairShape::sphere_plate
             ? retarded_plate_force(dispersion_, gap)
             : retarded_spheres_force(dispersion_, gap);
}

double SurfaceForces::born_energy(double gap) const {
  return pair_.shape == PairShape::sphere_plate
             ? born_plate_energy(pair_.hamaker, pair_.born_diameter, pair_.radius, gap)
             : born_spheres_energy(pair_.hamaker, pair_.born_diameter,
                                   double_layer_.radius, gap);
}

double SurfaceForces::born_force(double gap) const {
  return pair_.shape == PairShape::sphere_plate
             ? born_plate_force(pair_.hamaker, pair_.born_diameter, pair_.radius, gap)
             : born_spheres_force(pair_.hamaker, pair_.born_diameter,
                                  double_layer_.radius, gap);
}

}  // namespace colloid
