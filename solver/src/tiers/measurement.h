// What can be measured of a pore without time stepping.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "flow/wall_forces.h"
#include "observe/critical_diameter.h"
#include "scene/scene.h"
#include "tiers/flow_problem.h"
#include "tiers/regime.h"

namespace colloid {

/// Points at equal distances from `begin` to `end`, both included [m].
struct Line {
  Vec3 begin;
  Vec3 end;
  int points = 2;
};

struct MeasureOptions {
  GridChoice grid;
  std::vector<Sphere> deposit;  ///< retained colloids
  std::optional<Line> line;     ///< where the velocity is wanted
  int threads = 1;
};

struct ProfilePoint {
  Vec3 position;  ///< [m]
  Vec3 velocity;  ///< [m/s]
};

/// A body of the scene: how it moves, and what the liquid does to it.
struct BodyMeasurement {
  Vec3 velocity;  ///< [m/s]
  Vec3 spin;      ///< [rad/s]
  Wrench wrench;  ///< torque about its centre
};

struct Measurement {
  std::array<int, 3> cells{};
  Vec3 spacing;  ///< [m]
  StokesStatistics statistics;
  double pressure_drop = 0.0;  ///< [Pa]
  double flow_rate = 0.0;      ///< [m^3/s]
  Vec3 superficial_velocity;   ///< [m/s]
  double permeability = 0.0;   ///< [m^2]; not finite without drive or resistance
  Vec3 body_force;             ///< acting [N/m^3]
  WallForces forces;           ///< grains first, then the deposit
  std::vector<BodyMeasurement> bodies;
  CriticalDiameter critical;
  Regime regime;
  std::vector<ProfilePoint> profile;
};

/// Bodies move by (F18); `fidelity.lubrication` says whether gaps that the grid does not
/// resolve hinder them by (Q2) or too little.  Refuses a blocked throat whose drive holds
/// a flux (blocked under another drive: flow rate and permeability are 0) and a line that
/// leaves the box; throws ConvergenceError if the flow does not converge.
Measurement measure(const Scene& scene, const MeasureOptions& options);

}  // namespace colloid
