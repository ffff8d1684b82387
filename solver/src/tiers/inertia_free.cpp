#include "tiers/inertia_free.h"

#include <cmath>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "tiers/flow_problem.h"

namespace colloid {

namespace {

Vec3 weight_in_liquid(const Scene& scene) {
  const double a = 0.5 * scene.colloids->diameter;
  const double volume = 4.0 / 3.0 * kPi * a * a * a;
  return scene.gravity * (volume * (scene.colloids->density - scene.fluid.density));
}

void refuse_inertia(const Regime& regime, const char* tier) {
  require(!regime.colloids->models.inertia.needed, "/fidelity/tier", [&] {
    return fmt::format(
        "the tier {} neglects inertia, but {}; expected "
        "\"transient\" or a slower flow",
        tier, regime.colloids->models.inertia.reason);
  });
}

SurfaceModel contacts_of(const Scene& scene, double radius, double speed) {
  return make_surface_model(scene, stokes_drag(scene.fluid.viscosity, radius, speed));
}

std::shared_ptr<const SurfaceForces> attraction(const PairContact& contact) {
  return contact.attracts ? std::make_shared<const SurfaceForces>(contact.forces)
                          : nullptr;
}

}  // namespace

InertiaFreeScene::InertiaFreeScene(const Scene& the_scene, const RunOptions& options,
                                   const char* the_tier)
    : scene(the_scene),
      tier(the_tier),
      radius(0.5 * scene.colloids->diameter),
      inlet(clean_inlet(scene)),
      plan(make_injection_plan(scene, inlet.capture_gap)),
      flow(scene, choose_cells(scene, {}), options.threads),
      regime(regime_of(scene, flow)),
      contacts(contacts_of(scene, radius, inlet.mean_speed)),
      surfaces(scene.geometry.box, scene.geometry.spheres, hindrance_range(radius)) {
  refuse_inertia(regime, tier);
  for (const Sphere& grain : scene.geometry.spheres) {
    grain_radii.push_back(grain.radius);
  }
}

OneWayOptions InertiaFreeScene::motion_options(bool wall_hindrance,
                                               bool pair_hindrance) const {
  const ModelDecisions& models = regime.colloids->models;
  OneWayOptions motion;
  motion.radius = radius;
  motion.viscosity = scene.fluid.viscosity;
  motion.weight = models.gravity.needed ? weight_in_liquid(scene) : Vec3{};
  for (const Body& body : scene.geometry.bodies) {
    motion.given.push_back({body.force, body.torque});
  }
  motion.wall_hindrance = wall_hindrance;
  motion.pair_hindrance = pair_hindrance;
  motion.rules = contacts.rules;
  if (models.long_range_dlvo.needed && wall_hindrance) {
    // Repulsion is what keeps surfaces apart at the gap of contact; attraction pulls from
    // afar.
    motion.grain_forces = attraction(contacts.grain);
    motion.wall_forces = attraction(contacts.wall);
    motion.colloid_forces = attraction(contacts.colloid);
  }
  return motion;
}

LoopParts InertiaFreeScene::loop_parts(const RunOptions& options, MotionModel& motion) {
  const ModelDecisions& models = regime.colloids->models;
  return {flow,
          surfaces,
          motion,
          contacts,
          plan,
          inlet.mean_speed,
          models.brownian.needed,
          options.step_tolerance,
          tier,
          models.inertia.reason};
}

}  // namespace colloid
