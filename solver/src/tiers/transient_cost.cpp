#include "tiers/transient_cost.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/constants.h"
#include "scene/solid.h"

namespace colloid {

namespace {

// Measured (results/evidence/tier_windows): half a second of the reference scene, clean:
// 4612 steps of about 84,000 cells, 504 s of processor time; partly clogged: 14,598 of
// about 115,000, 1872 s: 1.3 and 1.1 us.  LIGGGHTS, 10 to 100 colloids: 4.8 us for a step
// of 100.  AMD EPYC virtual machine, 2 cores, busy.
constexpr double kSecondsPerCell = 1.2e-6;
constexpr double kSecondsPerColloidStep = 4.8e-8;

// About half of the colloids that entered are retained at the end of the reference
// ensemble, a quarter of them on average over the run.
constexpr double kMeanRetained = 0.25;

std::vector<Sphere> grown(std::vector<Sphere> spheres, double by) {
  for (Sphere& sphere : spheres) {
    sphere.radius += by;
  }
  return spheres;
}

/// Colloids in the box on average: those on their way through it, and the deposit.
double mean_colloids(const Scene& scene, const FlowScales& scales) {
  const Box& box = scene.geometry.box;
  double out = static_cast<double>(scene.geometry.bodies.size());
  for (int face = 0; face < kFaces; ++face) {
    if (box.face(face) != FaceCondition::inlet || scales.inlet_speed <= 0.0) {
      continue;
    }
    const int axis = axis_of(face);
    const double area = box.size[(axis + 1) % 3] * box.size[(axis + 2) % 3];
    const double a = 0.5 * scene.colloids->diameter;
    const double rate = scene.colloids->volume_fraction * scales.inlet_speed * area /
                        (4.0 / 3.0 * kPi * a * a * a);
    out += rate * std::min(scene.duration, box.size[axis] / scales.inlet_speed) +
           kMeanRetained * rate * scene.duration;
  }
  return out;
}

}  // namespace

TransientCost predict_transient_cost(const Scene& scene, const Regime& regime) {
  const Fidelity& fidelity = scene.fidelity;
  const Geometry& geometry = scene.geometry;
  const double d = scene.colloids->diameter;
  const double h = d / fidelity.cells_per_colloid;
  const Vec3& size = geometry.box.size;
  const double base_cells = size.x * size.y * size.z / (h * h * h);
  const double open = void_fraction(geometry.box, geometry.spheres);
  const double at_grains =
      fidelity.wall_refinement == 0
          ? 0.0
          : open - void_fraction(geometry.box, grown(geometry.spheres, h));
  const double colloids = mean_colloids(scene, regime.scales);
  // A base cell beside them is refined too.
  const double at_colloid = kPi / 6.0 * std::pow(d / h + 2.0, 3);
  const double added = std::pow(8.0, fidelity.refinement) - 1.0;

  TransientCost cost;
  cost.cells = base_cells * (open + 7.0 * at_grains) + colloids * at_colloid * added;
  const int finest =
      std::max(fidelity.refinement, at_grains > 0.0 ? fidelity.wall_refinement : 0);
  const double speed =
      std::max(regime.scales.largest_speed, std::abs(regime.colloids->settling_speed));
  cost.steps = scene.duration * speed * std::pow(2.0, finest) / (fidelity.courant * h);
  cost.seconds = cost.steps * cost.cells * kSecondsPerCell +
                 scene.duration / fidelity.dem_step * colloids * kSecondsPerColloidStep;
  return cost;
}

std::string cost_text(const TransientCost& cost) {
  return fmt::format("about {:.2g} steps of {:.2g} cells, {:.2g} core-hours", cost.steps,
                     cost.cells, cost.seconds / 3600.0);
}

}  // namespace colloid
