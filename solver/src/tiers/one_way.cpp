#include "tiers/one_way.h"

#include <cmath>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "particles/one_way_motion.h"
#include "tiers/flow_problem.h"
#include "tiers/flow_scales.h"
#include "tiers/injection.h"
#include "tiers/time_loop.h"

namespace colloid {

namespace {

Vec3 weight_in_liquid(const Scene& scene) {
  const double a = 0.5 * scene.colloids->diameter;
  const double volume = 4.0 / 3.0 * kPi * a * a * a;
  return scene.gravity * (volume * (scene.colloids->density - scene.fluid.density));
}

Regime regime_of(const Scene& scene, const DepositFlow& flow) {
  CriticalDiameterOptions search;
  search.flow_axis = flow.solver().flow_axis();
  const CriticalDiameter critical =
      critical_diameter(scene.geometry.box, scene.geometry.spheres, search);
  return analyse_regime(scene,
                        flow_scales(flow.solver(), flow.flow_rate(), critical.value));
}

void refuse_inertia(const Regime& regime) {
  require(!regime.colloids->models.inertia.needed, "/fidelity/tier", [&] {
    return fmt::format(
        "the tier one_way neglects inertia, but {}; expected "
        "\"transient\" or a slower flow",
        regime.colloids->models.inertia.reason);
  });
}

std::shared_ptr<const SurfaceForces> attraction(const PairContact& contact) {
  return contact.attracts ? std::make_shared<const SurfaceForces>(contact.forces)
                          : nullptr;
}

}  // namespace

std::optional<Realisation> run_one_way(const Scene& scene, const RunOptions& options) {
  const CleanInlet inlet = clean_inlet(scene);
  const InjectionPlan plan = make_injection_plan(scene, inlet.capture_gap);
  DepositFlow flow(scene, choose_cells(scene, {}), options.threads);
  const Regime regime = regime_of(scene, flow);
  refuse_inertia(regime);
  const ModelDecisions& models = regime.colloids->models;

  const double a = 0.5 * scene.colloids->diameter;
  const double drag = stokes_drag(scene.fluid.viscosity, a, inlet.mean_speed);
  const SurfaceModel contacts = make_surface_model(scene, drag);
  FixedSurfaces surfaces(scene.geometry.box, scene.geometry.spheres, hindrance_range(a));

  OneWayOptions motion;
  motion.radius = a;
  motion.viscosity = scene.fluid.viscosity;
  motion.weight = models.gravity.needed ? weight_in_liquid(scene) : Vec3{};
  motion.wall_hindrance = scene.fidelity.hindrance != Hindrance::none;
  motion.pair_hindrance = scene.fidelity.hindrance == Hindrance::wall_and_pair;
  motion.rules = contacts.rules;
  if (models.long_range_dlvo.needed && motion.wall_hindrance) {
    // Repulsion is what keeps surfaces apart at the gap of contact; attraction pulls from
    // afar.
    motion.grain_forces = attraction(contacts.grain);
    motion.wall_forces = attraction(contacts.wall);
    motion.colloid_forces = attraction(contacts.colloid);
  }
  std::vector<double> radii;
  for (const Sphere& grain : scene.geometry.spheres) {
    radii.push_back(grain.radius);
  }
  const OneWayMotion model(motion, flow, surfaces, radii);
  LoopParts parts{flow,      surfaces,
                  model,     contacts,
                  plan,      inlet.mean_speed,
                  false,     options.step_tolerance,
                  "one_way", models.inertia.reason};
  parts.brownian = models.brownian.needed;
  return TimeLoop(scene, options, parts).run();
}

}  // namespace colloid
