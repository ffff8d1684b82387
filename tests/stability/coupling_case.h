// One colloid that a stream in the throat carries, coupled to it in two ways.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.h"
#include "core/error.h"
#include "transient_flow/flow_scenes.h"

namespace colloid {

enum class Outcome { bounded, oscillating, unstable };

/// What became of its speed in `steps` steps of `step` [s], from rest in the developed
/// stream.  bounded: it goes to its final speed, past it by a tenth at most. oscillating:
/// further, or it changes direction every second step at the end.  unstable: more than
/// ten times the speed of the stream, or not a number.
struct CouplingResult {
  Outcome outcome = Outcome::bounded;
  double last_speed = 0.0;  ///< [m/s]
};

/// `refinement`, `rigidity`: of TransientFlowOptions.
inline CouplingResult coupled_motion(bool implicit, double density_ratio, double step,
                                     int steps, const Vec3& place, int cells,
                                     int refinement = 1, double rigidity = 1e3) {
  constexpr double kRadius = 6.65e-6;
  constexpr double kStream = 2.5e-3;  // at the throat [m/s]
  const Scene scene = throat_scene(5e-4);
  TransientFlowOptions options = base_cells(cells, cells, cells * 3 / 2, refinement);
  options.rigidity = rigidity;
  TransientFlow flow(scene, options);
  FlowBody body;
  body.sphere = {place, kRadius};
  body.mass = 4.0 / 3.0 * kPi * std::pow(kRadius, 3) * 1000.0 * density_ratio;
  flow.settle(1e-4, 1e-3, 60, {body});
  body.free = implicit;
  std::vector<double> speed;
  try {
    for (int n = 0; n < steps; ++n) {
      const FlowResponse response = flow.step(step, {body})[0];
      if (implicit) {
        body.velocity = response.velocity;
        body.spin = response.spin;
      } else {
        // The paper's: the force of the last fluid step moves the colloid, whose new
        // velocity the fluid is then given.
        const double inertia = 0.4 * body.mass * kRadius * kRadius;
        body.velocity += (step / body.mass) * response.force;
        body.spin += (step / inertia) * response.torque;
      }
      speed.push_back(-body.velocity.z);
      if (!(std::abs(speed.back()) < 10.0 * kStream)) {
        return {Outcome::unstable, speed.back()};
      }
    }
  } catch (const ConvergenceError&) {
    return {Outcome::unstable, speed.empty() ? 0.0 : speed.back()};
  }
  const double last = speed.back();
  const double most = *std::max_element(speed.begin(), speed.end());
  int turns = 0;
  for (std::size_t n = speed.size() - 10; n < speed.size(); ++n) {
    const double before = speed[n - 1] - speed[n - 2];
    const double after = speed[n] - speed[n - 1];
    turns += before * after < 0.0 && std::abs(after) > 1e-3 * std::abs(last) ? 1 : 0;
  }
  const bool oscillates = most > 1.1 * std::abs(last) || turns >= 5;
  return {oscillates ? Outcome::oscillating : Outcome::bounded, last};
}

}  // namespace colloid
