#include "tiers/regime.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "observe/critical_diameter.h"
#include "physics/surface_pair.h"
#include "tiers/deposit_flow.h"
#include "tiers/flow_scales.h"
#include "tiers/surface_model.h"

namespace colloid {

namespace {

constexpr int kPlanes = 400;
constexpr int kPoints = 200;

PairRegime analyse(const SurfacePair& pair, const FlowScales& scales, double viscosity) {
  const SurfaceForces forces(pair);
  PairRegime regime;
  regime.analysis = analyse_pair(forces);
  const auto gap_at = [&](double speed) {
    return speed > 0.0 ? van_der_waals_capture_gap(
                             forces, stokes_drag(viscosity, pair.radius, speed))
                       : (pair.hamaker > 0.0 ? HUGE_VAL : 0.0);
  };
  regime.capture_gap = gap_at(scales.inlet_speed);
  regime.capture_gap_throat = gap_at(scales.throat_speed);
  if (scales.inlet_speed > 0.0) {
    regime.range = interaction_range(
        forces, stokes_drag(viscosity, pair.radius, scales.inlet_speed));
  } else if (pair.hamaker > 0.0 || pair.zeta != 0.0 || pair.other_zeta != 0.0) {
    regime.range = HUGE_VAL;
  }
  return regime;
}

}  // namespace

double narrowest_open_area(const Box& box, const std::vector<Sphere>& spheres, int axis) {
  const int t1 = (axis + 1) % 3;
  const int t2 = (axis + 2) % 3;
  double narrowest = 1.0;
  std::vector<char> solid(static_cast<std::size_t>(kPoints) * kPoints);
  for (int plane = 0; plane <= kPlanes; ++plane) {
    const double height = box.size[axis] * plane / kPlanes;
    std::fill(solid.begin(), solid.end(), 0);
    for (const Sphere& s : spheres) {
      const auto shifts = [&](int a) { return box.periodic(a) ? 1 : 0; };
      for (int m0 = -shifts(axis); m0 <= shifts(axis); ++m0) {
        const double dz = height - s.center[axis] - m0 * box.size[axis];
        const double disc = s.radius * s.radius - dz * dz;
        if (disc <= 0.0) {
          continue;
        }
        for (int m1 = -shifts(t1); m1 <= shifts(t1); ++m1) {
          for (int m2 = -shifts(t2); m2 <= shifts(t2); ++m2) {
            const double c1 = s.center[t1] + m1 * box.size[t1];
            const double c2 = s.center[t2] + m2 * box.size[t2];
            const double step1 = box.size[t1] / kPoints;
            const double step2 = box.size[t2] / kPoints;
            const int first =
                std::max(0, static_cast<int>((c1 - std::sqrt(disc)) / step1 - 1.0));
            const int last = std::min(
                kPoints - 1, static_cast<int>((c1 + std::sqrt(disc)) / step1 + 1.0));
            for (int i = first; i <= last; ++i) {
              const double d1 = (i + 0.5) * step1 - c1;
              const double half = disc - d1 * d1;
              if (half <= 0.0) {
                continue;
              }
              const double w = std::sqrt(half);
              const int from =
                  std::max(0, static_cast<int>(std::ceil((c2 - w) / step2 - 0.5)));
              const int to = std::min(
                  kPoints - 1, static_cast<int>(std::floor((c2 + w) / step2 - 0.5)));
              for (int j = from; j <= to; ++j) {
                solid[static_cast<std::size_t>(i) * kPoints +
                      static_cast<std::size_t>(j)] = 1;
              }
            }
          }
        }
      }
    }
    const auto open = std::count(solid.begin(), solid.end(), 0);
    narrowest = std::min(
        narrowest, static_cast<double>(open) / (static_cast<double>(kPoints) * kPoints));
  }
  return narrowest * box.size[t1] * box.size[t2];
}

Regime analyse_regime(const Scene& scene, const FlowScales& scales) {
  const Fluid& fluid = scene.fluid;
  Regime regime;
  regime.scales = scales;
  regime.reynolds_throat = throat_reynolds(fluid.density, scales.throat_speed,
                                           scales.throat_diameter, fluid.viscosity);
  RegimeNumbers numbers;
  numbers.reynolds_throat = regime.reynolds_throat;
  if (!scene.colloids) {
    regime.inertia = decide_models(numbers).inertia;
    return regime;
  }
  const Colloids& colloids = *scene.colloids;
  const double a = 0.5 * colloids.diameter;
  ColloidRegime c;
  c.reynolds_particle = particle_reynolds(fluid.density, scales.inlet_speed,
                                          colloids.diameter, fluid.viscosity);
  c.stokes = stokes_number(colloids.density, a, scales.inlet_speed, fluid.viscosity);
  c.peclet = peclet_number(scales.inlet_speed, a,
                           diffusivity(fluid.temperature, fluid.viscosity, a));
  c.settling_speed = settling_speed(colloids.density, fluid.density, norm(scene.gravity),
                                    a, fluid.viscosity);
  c.stokes_largest = stokes_number(
      colloids.density, a, std::max(scales.largest_speed, std::abs(c.settling_speed)),
      fluid.viscosity);
  c.gravity_number = scales.inlet_speed > 0.0
                         ? gravity_number(c.settling_speed, scales.inlet_speed)
                     : std::abs(c.settling_speed) > 0.0 ? HUGE_VAL
                                                        : 0.0;
  c.relaxation_time = relaxation_time(colloids.density, a, fluid.viscosity);
  const SurfacePair grain = colloid_grain_pair(scene);
  c.debye_length = debye_length(grain.electrolyte);
  c.colloid_grain = analyse(grain, scales, fluid.viscosity);
  c.colloid_colloid = analyse(colloid_colloid_pair(scene), scales, fluid.viscosity);

  numbers.stokes = c.stokes_largest;
  numbers.peclet = c.peclet;
  numbers.gravity = c.gravity_number;
  numbers.dlvo_range_over_radius = c.colloid_grain.range / a;
  numbers.grain_barrier_kT = c.colloid_grain.analysis.barrier_from_secondary_kT;
  c.models = decide_models(numbers);
  regime.inertia = c.models.inertia;
  regime.colloids = c;
  return regime;
}

Regime regime_of(const Scene& scene, const DepositFlow& flow) {
  CriticalDiameterOptions search;
  search.flow_axis = flow.solver().flow_axis();
  const CriticalDiameter critical =
      critical_diameter(scene.geometry.box, scene.geometry.spheres, search);
  return analyse_regime(scene,
                        flow_scales(flow.solver(), flow.flow_rate(), critical.value));
}

}  // namespace colloid
