// Colloids of the reference scene in a box of their own, for the tests of the DEM.
#pragma once

#include <cmath>

#include "core/constants.h"
#include "tiers/transient/dem.h"

namespace colloid::dem_test {

constexpr double kRadius = 6.65e-6;  // [m]
constexpr double kDensity = 1050.0;  // [kg/m^3]
constexpr double kViscosity = 1e-3;  // [Pa s]
constexpr double kSpeed = 5e-4;      // at the inlet [m/s]
constexpr double kModulus = 70e6;    // [Pa]
constexpr double kPoisson = 0.3;
constexpr double kMass = kDensity * 4.0 / 3.0 * kPi * kRadius * kRadius * kRadius;
constexpr double kDrag = 6.0 * kPi * kViscosity * kRadius;
constexpr double kTorsion = 8.0 * kPi * kViscosity * kRadius * kRadius * kRadius;

inline SurfacePair grain_pair() {
  return {};
}

inline SurfacePair colloid_pair() {
  SurfacePair pair;
  pair.shape = PairShape::two_spheres;
  pair.other_zeta = pair.zeta;
  pair.double_layer = DoubleLayerForm::superposition;
  return pair;
}

/// As tiers/surface_model.cpp for a scene whose walls are inert.
inline SurfaceModel surface_model(const SurfacePair& grain = grain_pair(),
                                  const SurfacePair& colloid = colloid_pair()) {
  const double drag = kDrag * kSpeed;
  SurfaceModel model{
      meet(grain, drag), meet(grain_pair(), drag), meet(colloid, drag), {}};
  model.rules.grain_gap = model.grain.gap;
  model.rules.wall_gap = model.wall.gap;
  model.rules.colloid_gap = 6e-9;
  model.rules.grains_attach = model.grain.attracts;
  model.rules.colloids_attach = true;
  model.rules.grain_repulsion = model.grain.analysis.primary_minimum
                                    ? model.grain.analysis.largest_repulsion.force
                                    : HUGE_VAL;
  return model;
}

/// A closed box of 200 um, no weight, nothing attaches and nothing acts at a distance.
inline DemOptions inert() {
  DemOptions options(surface_model());
  options.box = {{2e-4, 2e-4, 2e-4},
                 {FaceCondition::wall, FaceCondition::wall, FaceCondition::wall,
                  FaceCondition::wall, FaceCondition::wall, FaceCondition::wall}};
  options.radius = kRadius;
  options.density = kDensity;
  options.fluid_density = 1000.0;
  options.viscosity = kViscosity;
  options.colloid = {kModulus, kPoisson};
  options.grain = {20e9, kPoisson};
  ContactRules& rules = options.surfaces.rules;
  rules.grains_attach = rules.colloids_attach = rules.walls_attach = false;
  rules.grain_repulsion = rules.wall_repulsion = HUGE_VAL;
  return options;
}

/// Nothing attaches to grains or walls, colloids bond.
inline DemOptions bonding() {
  DemOptions options = inert();
  options.surfaces.rules.colloids_attach = true;
  return options;
}

inline DemLoad stokes_drag(int id, const Vec3& velocity, const Vec3& force = {}) {
  DemLoad load;
  load.id = id;
  load.velocity = velocity;
  load.force = force;
  load.drag = kDrag;
  load.torsion = kTorsion;
  return load;
}

constexpr Vec3 kMiddle{1e-4, 1e-4, 1e-4};

}  // namespace colloid::dem_test
