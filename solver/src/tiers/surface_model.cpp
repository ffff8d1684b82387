#include "tiers/surface_model.h"

#include <algorithm>
#include <cmath>

namespace colloid {

namespace {

SurfacePair common_pair(const Scene& scene) {
  const SurfaceChemistry& surface = scene.surface;
  SurfacePair pair;
  pair.radius = 0.5 * scene.colloids->diameter;
  pair.other_radius = pair.radius;
  pair.zeta = surface.zeta_colloid;
  pair.born_diameter = surface.born_diameter;
  pair.van_der_waals = surface.van_der_waals == VanDerWaals::retarded
                           ? VanDerWaalsForm::retarded
                           : VanDerWaalsForm::unretarded;
  pair.electrolyte = {surface.ionic_strength, scene.fluid.relative_permittivity,
                      scene.fluid.temperature};
  return pair;
}

SurfacePair plate_pair(const Scene& scene, double zeta, double hamaker) {
  SurfacePair pair = common_pair(scene);
  pair.shape = PairShape::sphere_plate;
  pair.other_zeta = zeta;
  pair.hamaker = hamaker;
  pair.double_layer = DoubleLayerForm::constant_potential;
  return pair;
}

// Where surfaces that repel stop: at the outermost gap where they do so with the drag.
double standoff(const PairContact& contact, double drag) {
  const double range = interaction_range(contact.forces, drag);
  return contact.forces.force(range) > 0.0 ? range
                                           : contact.analysis.largest_repulsion.gap;
}

// A minimum given by the scene: the same curve, as deep as that.
void deepen(PairContact& contact, const std::optional<StationaryPoint>& minimum,
            const std::optional<double>& energy) {
  if (energy && minimum && minimum->energy < 0.0) {
    contact.pull_off *= *energy / minimum->energy;
  }
}

}  // namespace

SurfacePair colloid_grain_pair(const Scene& scene) {
  return plate_pair(scene, scene.surface.zeta_grain, scene.surface.hamaker_colloid_grain);
}

SurfacePair colloid_wall_pair(const Scene& scene) {
  return plate_pair(scene, scene.surface.zeta_wall, scene.surface.hamaker_colloid_wall);
}

SurfacePair colloid_colloid_pair(const Scene& scene) {
  SurfacePair pair = common_pair(scene);
  pair.shape = PairShape::two_spheres;
  pair.other_zeta = scene.surface.zeta_colloid;
  pair.hamaker = scene.surface.hamaker_colloid_colloid;
  pair.double_layer = scene.surface.double_layer == DoubleLayer::derjaguin
                          ? DoubleLayerForm::constant_potential
                          : DoubleLayerForm::superposition;
  return pair;
}

PairContact meet(const SurfacePair& pair, double drag) {
  PairContact contact{SurfaceForces(pair), {}, false, 0.0, 0.0};
  contact.analysis = analyse_pair(contact.forces);
  const PairAnalysis& analysis = contact.analysis;
  const double barrier =
      std::max(analysis.barrier_from_outside_kT, analysis.barrier_from_secondary_kT);
  contact.attracts = analysis.primary_minimum && barrier < kLeastBarrier;
  const double least = pair.closest_gap;
  if (contact.attracts) {
    contact.pull_off = analysis.primary_pull_off.force;
    contact.gap = std::max(least, van_der_waals_capture_gap(contact.forces, drag));
  } else {
    contact.pull_off =
        analysis.secondary_minimum ? analysis.secondary_pull_off.force : 0.0;
    contact.gap = std::max(least, standoff(contact, drag));
  }
  return contact;
}

SurfaceModel make_surface_model(const Scene& scene, double drag) {
  SurfaceModel model{meet(colloid_grain_pair(scene), drag),
                     meet(colloid_wall_pair(scene), drag),
                     meet(colloid_colloid_pair(scene), drag),
                     {}};
  // Two colloids also hold together outside their barrier, if the minimum there is deep.
  PairContact& colloid = model.colloid;
  const auto& secondary = colloid.analysis.secondary_minimum;
  if (!colloid.attracts && secondary && secondary->energy_kT < -kLeastBarrier) {
    colloid.attracts = true;
    colloid.gap =
        std::max(secondary->gap, van_der_waals_capture_gap(colloid.forces, drag));
  }
  deepen(model.grain, model.grain.analysis.primary_minimum,
         scene.surface.primary_minimum);
  deepen(colloid, secondary ? secondary : colloid.analysis.primary_minimum,
         scene.surface.colloid_colloid_minimum);
  ContactRules& rules = model.rules;
  rules.grain_gap = model.grain.gap;
  rules.wall_gap = model.wall.gap;
  rules.colloid_gap = colloid.gap;
  if (scene.fidelity.capture_gap) {
    const double given = *scene.fidelity.capture_gap;
    rules.grain_gap = model.grain.attracts ? given : rules.grain_gap;
    rules.wall_gap = model.wall.attracts ? given : rules.wall_gap;
    rules.colloid_gap = colloid.attracts ? given : rules.colloid_gap;
  }
  const bool adhesive = scene.walls == Walls::adhesive;
  rules.grains_attach = model.grain.attracts;
  rules.walls_attach = adhesive && model.wall.attracts;
  rules.colloids_attach = colloid.attracts;
  rules.aggregates = scene.aggregates;
  // Without a minimum to fall into no push makes a colloid stick.
  const auto repulsion = [](const PairContact& contact) {
    return contact.analysis.primary_minimum ? contact.analysis.largest_repulsion.force
                                            : HUGE_VAL;
  };
  rules.grain_repulsion = repulsion(model.grain);
  rules.wall_repulsion = adhesive ? repulsion(model.wall) : HUGE_VAL;
  return model;
}

}  // namespace colloid
