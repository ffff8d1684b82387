// A colloid that a weight presses towards a wall through a narrow gap, or pulls along it:
// flow, discrete elements and sub-grid lubrication exchange as in a run.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.h"
#include "core/error.h"
#include "coupling_case.h"
#include "dem/dem_case.h"
#include "physics/wall_resistance.h"
#include "tiers/transient/dem.h"
#include "tiers/transient/transient_flow.h"

namespace colloid {

enum class Weight { towards_wall, along_wall };

/// Speed of a weight near the wall over that far from walls; free to turn.
inline double hindered(Weight weight, double gap) {
  const WallResistance w = wall_resistance(std::max(gap, 1e-6));
  return weight == Weight::towards_wall
             ? 1.0 / w.f_n
             : w.t_r / (w.f_t * w.t_r - 4.0 / 3.0 * w.t_t * w.t_t);
}

/// From rest at `gap` [radii], `steps` flow steps of `step` [s].  bounded: its speed
/// never passes that of the weight against the exact resistance by more than half, and it
/// stays off the wall; oscillating: further, or it goes back, or changes direction at
/// five of the last eight steps; unstable: twice as fast as the weight makes it far from
/// walls, or not a number.
inline CouplingResult moved_at_wall(Weight weight, double gap, double step, int steps) {
  using dem_test::kDrag;
  using dem_test::kRadius;
  constexpr double kSpeed = 1e-4;  // far from walls [m/s]
  DemOptions dem_options = dem_test::inert();
  const double length = 6.0 * kRadius;
  dem_options.box.size = {length, length, length};
  const double mass = dem_options.density * 4.0 / 3.0 * kPi * std::pow(kRadius, 3);
  const double buoyant = mass * (1.0 - 1000.0 / dem_options.density);
  const Vec3 direction =
      weight == Weight::towards_wall ? Vec3{0.0, 0.0, -1.0} : Vec3{1.0, 0.0, 0.0};
  dem_options.gravity = (kDrag * kSpeed / buoyant) * direction;
  Scene scene;
  scene.geometry.box = dem_options.box;
  TransientFlowOptions options;
  options.cells = {12, 12, 12};
  options.refinement = 1;
  TransientFlow flow(scene, options);
  dem_options.lubrication = true;
  dem_options.lubrication_cell = flow.cell_at_bodies();
  Dem dem(dem_options, {});
  dem.add({0, {0.5 * length, 0.5 * length, (1.0 + gap) * kRadius}, {}, {}});
  Vec3 force = (kDrag * kSpeed) * direction;
  Vec3 torque;
  std::vector<double> speed;
  bool too_fast = false;
  try {
    for (int n = 0; n < steps; ++n) {
      const DemState state = dem.states().at(0);
      FlowBody body;
      body.sphere = {state.position, kRadius};
      body.free = true;
      body.mass = mass;
      body.velocity = state.velocity;
      body.spin = state.spin;
      body.force = force;
      body.torque = torque;
      const FlowResponse response = flow.step(step, {halfway(body, step)})[0];
      const DemLoad load{
          0,     response.force,    response.torque, response.velocity, response.spin,
          kDrag, dem_test::kTorsion};
      const DemStep moved = dem.advance(step, {load});
      force = moved.means.at(0).force;
      torque = moved.means.at(0).torque;
      const DemState after = dem.states().at(0);
      speed.push_back(dot(after.velocity, direction));
      const double now = after.position.z / kRadius - 1.0;
      if (!(std::abs(speed.back()) < 2.0 * kSpeed) || now <= 0.0) {
        return {Outcome::unstable, speed.back()};
      }
      const double exact = kSpeed * hindered(weight, now);
      too_fast = too_fast || speed.back() > 1.5 * exact || speed.back() < -0.05 * exact;
    }
  } catch (const ConvergenceError&) {
    return {Outcome::unstable, speed.empty() ? 0.0 : speed.back()};
  }
  int turns = 0;
  for (std::size_t n = speed.size() - 8; n < speed.size(); ++n) {
    const double before = speed[n - 1] - speed[n - 2];
    const double after = speed[n] - speed[n - 1];
    turns += before * after < 0.0 && std::abs(after) > 1e-2 * std::abs(speed[n]) ? 1 : 0;
  }
  return {too_fast || turns >= 5 ? Outcome::oscillating : Outcome::bounded, speed.back()};
}

}  // namespace colloid
