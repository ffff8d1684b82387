// The last diameter of ten Cate's falls, with lubrication below the grid and without, as
// CSV: gap over diameter, time since the gap was a diameter [s], speed [m/s], and the
// speed at which Brenner (1961) balances the weight.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "../dem/dem_case.h"
#include "../transient_flow/settling_case.h"
#include "physics/wall_resistance.h"
#include "tiers/transient/runtime.h"

namespace colloid {
namespace {

constexpr double kDiameter = kSphereDiameter;
constexpr double kLastGap = 0.01;  // over the diameter

DemOptions sphere_above(const Scene& scene, double cell, bool lubrication) {
  DemOptions options = dem_test::inert();
  options.box = scene.geometry.box;
  options.radius = 0.5 * kDiameter;
  options.density = kSphereDensity;
  options.fluid_density = scene.fluid.density;
  options.viscosity = scene.fluid.viscosity;
  options.gravity = {0.0, 0.0, -9.81};
  options.colloid.young_modulus = 1e6;
  options.step = 0.3 * step_limits(options).largest();
  options.lubrication = lubrication;
  options.lubrication_cell = cell;
  return options;
}

void print_fall(const Experiment& e, int cells, bool lubrication) {
  const Scene scene = closed_box(e);
  TransientFlow flow(scene, box_cells(cells));
  const double a = 0.5 * kDiameter;
  Dem dem(sphere_above(scene, flow.cell_at_bodies(), lubrication), {});
  FlowBody body = free_sphere({0.05, 0.05, 0.12 + a}, a, kSphereDensity, weight(e));
  const Vec3 full = body.force;
  dem.add({0, body.sphere.center, {}, {}, false});
  double t = 0.0;
  double since = -1.0;
  for (double gap = 0.12; gap > kLastGap * kDiameter && t < 20.0;) {
    const double speed = std::max(norm(body.velocity), 1e-6);
    const double dt = std::min({0.005, 0.3 * flow.courant_time(),
                                0.3 * flow.cell_at_bodies() / speed, 0.2 * gap / speed});
    const FlowResponse answer = flow.step(dt, {halfway(body, dt)})[0];
    const DemLoad load{0,
                       answer.force,
                       answer.torque,
                       answer.velocity,
                       answer.spin,
                       6.0 * kPi * e.viscosity * a,
                       8.0 * kPi * e.viscosity * a * a * a};
    const DemStep moved = dem.advance(dt, {load});
    body.force = moved.means.at(0).force;
    body.torque = moved.means.at(0).torque;
    const DemState state = dem.states().at(0);
    body.sphere.center = state.position;
    body.velocity = state.velocity;
    body.spin = state.spin;
    t += dt;
    gap = state.position.z - a;
    if (gap < kDiameter) {
      since = since < 0.0 ? t : since;
      std::printf(
          "%.2s,%d,%s,%.5f,%.4f,%.6f,%.6f\n", e.name, cells,
          lubrication ? "full" : "resolved_only", gap / kDiameter, t - since,
          -state.velocity.z,
          norm(full) / (6.0 * kPi * e.viscosity * a * wall_resistance(gap / a).f_n));
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace colloid

int main(int argc, char** argv) {
  using namespace colloid;
  const Runtime runtime(argc, argv);
  if (argc != 4) {
    std::fputs("usage: last_diameter E1|E4 CELLS_PER_DIAMETER full|resolved_only\n",
               stderr);
    return 2;
  }
  print_fall(std::strcmp(argv[1], "E1") == 0 ? kSlow : kFast, std::atoi(argv[2]),
             std::strcmp(argv[3], "full") == 0);
  return 0;
}
