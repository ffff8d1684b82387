// Spheres that the flow carries: see README.md beside this file.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "flow_scenes.h"
#include "tiers/measurement.h"

namespace colloid {
namespace {

constexpr double kRadius = 6.65e-6;
const Vec3 kPlace{60e-6, 52e-6, 75e-6};  // in the throat, off its axis

// Its motion in the throat once it has forgotten how it started, held in place.
FlowBody carried(double density_ratio, double dt, int steps, int cells, int passes) {
  const Scene scene = throat_scene(5e-4);
  TransientFlowOptions options = base_cells(cells, cells, cells * 3 / 2, 1);
  options.outer_iterations = passes;
  TransientFlow flow(scene, options);
  std::vector<FlowBody> bodies{free_sphere(kPlace, kRadius, 1000.0 * density_ratio)};
  bodies[0].free = false;
  flow.settle(1e-4, 1e-3, 60, bodies);
  bodies[0].free = true;
  for (int n = 0; n < steps; ++n) {
    const std::vector<FlowResponse> moved = flow.step(dt, bodies);
    bodies[0].velocity = moved[0].velocity;
    bodies[0].spin = moved[0].spin;
  }
  return bodies[0];
}

// The same from the tier quasi_steady's solver: another grid, other equations, no time.
BodyMeasurement quasi_steady() {
  Scene scene = throat_scene(5e-4);
  scene.geometry.bodies.push_back({{kPlace, kRadius}, {}, {}, {}});
  scene.fidelity.tolerance = 1e-5;
  MeasureOptions options;
  options.grid.cells = std::array<int, 3>{58, 58, 87};
  return measure(scene, options).bodies.at(0);
}

// Distance of two vectors over the length of the second.
double difference(const Vec3& a, const Vec3& b) {
  return norm(a - b) / norm(b);
}

TEST(TransientBody, MovesAsInQuasiSteadyFlow) {
  const BodyMeasurement reference = quasi_steady();
  const FlowBody coarse = carried(1.0, 1e-4, 40, 26, 1);  // 7 cells per diameter
  const FlowBody fine = carried(1.0, 1e-4, 40, 36, 1);    // 10
  // Stokes' flow at Re_throat 0.1: inertia itself moves these by less than 1 %.
  EXPECT_LT(difference(coarse.velocity, reference.velocity), 0.015);
  EXPECT_LT(difference(fine.velocity, reference.velocity), 0.0075);
  EXPECT_LT(difference(fine.spin, reference.spin), 0.02);
}

// The relaxation time is 10 us: steps of 10 and 100 of it, bodies from half to eight
// times as dense as the liquid.  What is left of the splitting of momentum and pressure
// after 24 steps of two passes is 0.5 %.
TEST(TransientBody, KnowsNeitherRatioOfDensitiesNorStep) {
  const Vec3 reference = carried(1.05, 1e-4, 40, 26, 1).velocity;
  for (const double ratio : {0.5, 1.0, 8.0}) {
    EXPECT_LT(difference(carried(ratio, 1e-3, 24, 26, 2).velocity, reference), 0.02)
        << ratio;
  }
}

// Response to a force in a liquid at rest, far from walls: the impulsive start of a
// sphere, whose speed is that of its mass and half of the displaced liquid's at first,
// and Stokes' at last.
TEST(TransientBody, StartsWithItsAddedMass) {
  Scene scene;
  const double length = 10.0 * kRadius;
  scene.geometry.box = {
      {length, length, length},
      {kPeriodic, kPeriodic, kPeriodic, kPeriodic, kPeriodic, kPeriodic}};
  const double volume = 4.0 / 3.0 * kPi * std::pow(kRadius, 3);
  for (const double ratio : {0.5, 1.05, 8.0}) {
    TransientFlow flow(scene, base_cells(25, 25, 25, 1));
    const double force = 1e-12;
    std::vector<FlowBody> bodies{free_sphere({0.51 * length, 0.5 * length, 0.49 * length},
                                             kRadius, 1000.0 * ratio, {force, 0.0, 0.0})};
    const double dt = 1e-8;  // viscous layer: 0.1 um
    const double speed = flow.step(dt, bodies)[0].velocity.x;
    const double mass = force * dt / speed;
    // Added mass of a simple-cubic array at c = 0.004: 0.5 (1 + 3 c) of the displaced
    // (the array's mean flow is held at rest by nothing: it drifts with momentum c); what
    // the viscous layer adds is 9/a sqrt(nu dt/pi) of the displaced mass, 8 %.
    EXPECT_GT(mass / (1000.0 * volume), ratio + 0.45) << ratio;
    EXPECT_LT(mass / (1000.0 * volume), ratio + 0.75) << ratio;
  }
}

}  // namespace
}  // namespace colloid
