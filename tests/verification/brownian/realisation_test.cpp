// Brownian motion as a realisation has it: the time loop chooses steps and draws.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "constructed_run.h"
#include "core/constants.h"

namespace colloid {
namespace {

// Colloids of 1 um in a slow stream, far from walls and from each other.
Scene slow_scene() {
  Scene scene = cases::one_grain_scene();
  scene.geometry.spheres = {{{30e-6, 30e-6, 5e-6}, 5e-6}};
  scene.drive.inlet_velocity = 1e-6;
  scene.colloids->diameter = 1e-6;
  scene.fidelity.cells_per_colloid = 0.25;
  scene.fidelity.hindrance = Hindrance::none;
  return scene;
}

// <x^2> = 2 D t across the stream between two frames, whether the outputs cut the thermal
// steps short (1 ms, a third of a step) or not (10 ms).
TEST(BrownianRealisation, DiffusesBetweenOutputsAsStokesAndEinsteinSay) {
  constexpr double kDiffusivity = kBoltzmann * 298.0 / (6.0 * kPi * 1e-3 * 0.5e-6);
  for (double duration : {0.5, 5.0}) {
    Scene scene = slow_scene();
    scene.duration = duration;
    cases::Start start;
    for (int n = 0; n < 16; ++n) {
      start.bodies.push_back(
          cases::released_at({18e-6 + (n % 4) * 8e-6, 18e-6 + (n / 4) * 8e-6, 60e-6}, n));
    }
    const Realisation r = cases::run_from(scene, start, 5);
    double sum = 0.0;
    double draws = 0.0;
    for (std::size_t f = 1; f < r.frames.size(); ++f) {
      ASSERT_EQ(r.frames[f].colloids.size(), 16u);
      for (std::size_t c = 0; c < 16; ++c) {
        const Vec3 d =
            r.frames[f].colloids[c].position - r.frames[f - 1].colloids[c].position;
        sum += d.x * d.x + d.y * d.y;
        draws += 2.0;
      }
    }
    const double ratio = sum / (draws * 2.0 * kDiffusivity * duration / 500.0);
    std::printf("outputs every %g s: <x^2> / 2 D t = %.4f\n", duration / 500.0, ratio);
    EXPECT_EQ(r.frames.size(), 501u);
    // Four standard errors of so many squares.
    EXPECT_NEAR(ratio, 1.0, 4.0 * std::sqrt(2.0 / draws));
  }
}

}  // namespace
}  // namespace colloid
