// Spheres that settle in a closed box.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "flow_scenes.h"

namespace colloid {

// ten Cate et al. (2002), Phys. Fluids 14, 4012, table 1 and figures 5, 6.
struct Experiment {
  const char* name;
  double density;    // of the liquid [kg/m^3]
  double viscosity;  // [Pa s]
  double peak;       // largest speed of the fall [m/s]
};
constexpr double kSphereDiameter = 0.015;  // [m]
constexpr double kSphereDensity = 1120.0;  // [kg/m^3]
constexpr Experiment kSlow{"E1, Re 1.5", 970.0, 0.373, 0.035986};
constexpr Experiment kFast{"E4, Re 31.9", 960.0, 0.058, 0.12224};

struct Fall {
  double peak = 0.0;
  double drift = 0.0;     // sideways, largest [m]
  double rebound = 0.0;   // largest upward speed [m/s]
  double last_gap = 0.0;  // [m]
};

/// The box of the experiments, and the grid of `cells_per_diameter` at the sphere.
inline Scene closed_box(const Experiment& e) {
  Scene scene;
  scene.fluid.density = e.density;
  scene.fluid.viscosity = e.viscosity;
  scene.geometry.box = {{0.1, 0.1, 0.16}, {kWall, kWall, kWall, kWall, kWall, kWall}};
  return scene;
}

inline TransientFlowOptions box_cells(int cells_per_diameter) {
  const int n =
      static_cast<int>(std::lround(0.1 / kSphereDiameter * cells_per_diameter / 2.0));
  TransientFlowOptions options = base_cells(n, n, n * 8 / 5, 1);
  options.outer_iterations = 2;
  return options;
}

/// Less the buoyancy [N].
inline Vec3 weight(const Experiment& e) {
  return {
      0.0, 0.0,
      -9.81 * (kSphereDensity - e.density) * kPi / 6.0 * std::pow(kSphereDiameter, 3)};
}

inline Fall fall(const Experiment& e, int cells_per_diameter, double until_gap) {
  constexpr double kRadius = 0.5 * kSphereDiameter;
  const Scene scene = closed_box(e);
  TransientFlow flow(scene, box_cells(cells_per_diameter));
  std::vector<FlowBody> bodies{
      free_sphere({0.05, 0.05, 0.12 + kRadius}, kRadius, kSphereDensity, weight(e))};
  Fall out;
  double t = 0.0;
  while (bodies[0].sphere.center.z > kRadius + until_gap) {
    const double dt = std::min(
        {0.005, 0.3 * flow.courant_time(),
         0.3 * flow.cell_at_bodies() / std::max(norm(bodies[0].velocity), 1e-6)});
    const FlowResponse moved = flow.step(dt, bodies)[0];
    bodies[0].velocity = moved.velocity;
    bodies[0].spin = moved.spin;
    bodies[0].sphere.center += dt * moved.velocity;
    t += dt;
    out.peak = std::max(out.peak, -moved.velocity.z);
    out.rebound = std::max(out.rebound, moved.velocity.z);
    out.drift = std::max(out.drift, std::hypot(bodies[0].sphere.center.x - 0.05,
                                               bodies[0].sphere.center.y - 0.05));
    if (t > 10.0) {
      break;
    }
  }
  out.last_gap = bodies[0].sphere.center.z - kRadius;
  return out;
}

/// Within 3 % of the peak, straight down, without a rebound.
inline void expect_fall(const Experiment& e, int cells_per_diameter) {
  const Fall found = fall(e, cells_per_diameter, 0.05 * kSphereDiameter);
  EXPECT_NEAR(found.peak / e.peak, 1.0, 0.03);
  EXPECT_LT(found.drift, 1e-3 * kSphereDiameter);
  EXPECT_EQ(found.rebound, 0.0);
}

}  // namespace colloid
