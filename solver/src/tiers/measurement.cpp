#include "tiers/measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "flow/interpolation.h"
#include "tiers/flow_scales.h"
#include "tiers/gap_lubrication.h"

namespace colloid {

namespace {

std::vector<ProfilePoint> sample(const StokesSolver& solver, const Line& line) {
  std::vector<ProfilePoint> points;
  for (int n = 0; n < line.points; ++n) {
    const double t = static_cast<double>(n) / (line.points - 1);
    const Vec3 x = line.begin * (1.0 - t) + line.end * t;
    points.push_back({x, velocity_at(solver, x)});
  }
  return points;
}

bool inside(const Box& box, const Vec3& x) {
  for (int a = 0; a < 3; ++a) {
    if (!(x[a] >= 0.0 && x[a] <= box.size[a])) {
      return false;
    }
  }
  return true;
}

CriticalDiameter critical_along(const StokesProblem& problem, int axis) {
  CriticalDiameterOptions search;
  search.flow_axis = axis;
  return critical_diameter(problem.box, problem.spheres, search);
}

// A flux that is to be held needs a way; `critical` is that along the flow's axis.
void refuse_blocked(const StokesProblem& problem, const CriticalDiameter& critical) {
  const FlowDrive& drive = problem.drive;
  require(
      !critical.blocked || drive.kind != FlowDrive::Kind::inlet_velocity,
      "/drive/inlet_velocity",
      "the way from the inlet to the outlet is blocked (critical diameter 0), no flux "
      "can be held; expected a pressure_drop");
  if (drive.kind != FlowDrive::Kind::mean_velocity) {
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (drive.mean_velocity[axis] == 0.0) {
      continue;
    }
    const bool blocked = axis == flow_axis(problem)
                             ? critical.blocked
                             : critical_along(problem, axis).blocked;
    require(!blocked, "/drive/mean_velocity",
            fmt::format("the way along {} is blocked (critical diameter 0), no flux can "
                        "be held; expected a body_force",
                        "xyz"[axis]));
  }
}

bool has_resistance(const StokesProblem& problem) {
  const auto& faces = problem.box.faces;
  return !problem.spheres.empty() ||
         std::find(faces.begin(), faces.end(), FaceCondition::wall) != faces.end();
}

// Without a wall or a sphere nothing holds the fluid: no steady flow under a force, and
// no force to hold a mean velocity.
void refuse_unresisted(const StokesProblem& problem) {
  if (has_resistance(problem)) {
    return;
  }
  const auto refuse = [&](FlowDrive::Kind kind, const char* where) {
    require(problem.drive.kind != kind, where,
            "meets no resistance: the box has neither walls nor spheres");
  };
  refuse(FlowDrive::Kind::pressure_drop, "/drive/pressure_drop");
  refuse(FlowDrive::Kind::body_force, "/drive/body_force");
  refuse(FlowDrive::Kind::mean_velocity, "/drive/mean_velocity");
}

std::vector<MovingBody> moving_bodies(const Scene& scene) {
  std::vector<MovingBody> out;
  for (const Body& body : scene.geometry.bodies) {
    out.push_back({body.sphere.center, {body.sphere}});
  }
  return out;
}

// Free under its force and torque, or moved without turning.
BodyBalance balance_of(const Scene& scene, const std::vector<MovingBody>& moving) {
  BodyBalance balance = free_bodies(moving, scene.fluid.viscosity);
  std::vector<Eigen::Index> unknown;
  for (std::size_t b = 0; b < moving.size(); ++b) {
    const Body& body = scene.geometry.bodies[b];
    const auto at = 6 * static_cast<Eigen::Index>(b);
    for (int a = 0; a < 3; ++a) {
      balance.load[at + a] = body.force[a];
      balance.load[at + 3 + a] = body.torque[a];
      balance.given[at + a] = body.velocity ? (*body.velocity)[a] : 0.0;
    }
    for (Eigen::Index n = 0; n < 6 && !body.velocity; ++n) {
      unknown.push_back(at + n);
    }
  }
  const Eigen::MatrixXd all = balance.motions;
  balance.motions.resize(all.rows(), static_cast<Eigen::Index>(unknown.size()));
  for (std::size_t n = 0; n < unknown.size(); ++n) {
    balance.motions.col(static_cast<Eigen::Index>(n)) = all.col(unknown[n]);
  }
  return balance;
}

// Zero for what is to be resolved only.
GapLubrication lubrication_of(const Scene& scene, const StokesProblem& problem,
                              double cell) {
  if (scene.fidelity.lubrication == Lubrication::full) {
    return gap_lubrication(scene, problem.spheres, cell);
  }
  const auto n = 6 * static_cast<Eigen::Index>(scene.geometry.bodies.size());
  return {Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
}

// Something besides the bodies must hold the liquid, or all of it drifts freely.
void refuse_drifting(const Scene& scene, const StokesProblem& problem) {
  const auto& faces = problem.box.faces;
  const auto& bodies = scene.geometry.bodies;
  const bool held =
      has_resistance(problem) ||
      std::find(faces.begin(), faces.end(), FaceCondition::inlet) != faces.end() ||
      std::any_of(bodies.begin(), bodies.end(),
                  [](const Body& body) { return body.velocity.has_value(); });
  require(
      bodies.empty() || held, "/geometry/bodies",
      "drift with the liquid, which nothing holds; expected a wall, an inlet, a fixed "
      "sphere or a body with a velocity");
}

std::vector<BodyMeasurement> measured_bodies(const StokesSolver& solver,
                                             const GapLubrication& gaps) {
  const auto part = [](const Eigen::VectorXd& six, std::size_t at) {
    const auto n = static_cast<Eigen::Index>(at);
    return Vec3{six[n], six[n + 1], six[n + 2]};
  };
  const Eigen::VectorXd wrench =
      solver.body_wrench() + gaps.drive - gaps.resistance * solver.body_motion();
  std::vector<BodyMeasurement> out;
  for (std::size_t b = 0; 6 * b < static_cast<std::size_t>(wrench.size()); ++b) {
    out.push_back({part(solver.body_motion(), 6 * b),
                   part(solver.body_motion(), 6 * b + 3),
                   {part(wrench, 6 * b), part(wrench, 6 * b + 3)}});
  }
  return out;
}

}  // namespace

Measurement measure(const Scene& scene, const MeasureOptions& options) {
  if (options.line) {
    require(inside(scene.geometry.box, options.line->begin) &&
                inside(scene.geometry.box, options.line->end),
            "--profile", "leaves the box; expected both ends in it");
  }
  Measurement m;
  m.cells = choose_cells(scene, options.grid);
  const StokesProblem problem = make_flow_problem(scene, options.deposit, m.cells);
  for (int a = 0; a < 3; ++a) {
    m.spacing[a] = problem.box.size[a] / m.cells[static_cast<std::size_t>(a)];
  }

  StokesOptions flow;
  flow.tolerance = scene.fidelity.tolerance;
  flow.threads = options.threads;
  m.critical = critical_along(problem, std::max(0, flow_axis(problem)));
  refuse_blocked(problem, m.critical);
  refuse_unresisted(problem);

  refuse_drifting(scene, problem);

  StokesSolver solver(problem, flow);
  const std::vector<MovingBody> moving = moving_bodies(scene);
  if (moving.empty()) {
    m.statistics = solver.solve();
  } else {
    const GapLubrication gaps = lubrication_of(scene, problem, solver.length_unit());
    BodyBalance balance = balance_of(scene, moving);
    balance.resistance = gaps.resistance;
    balance.load += gaps.drive;
    solver.set_bodies(moving);
    m.statistics = solver.solve(balance);
    m.bodies = measured_bodies(solver, gaps);
  }
  m.pressure_drop = solver.pressure_drop();
  m.superficial_velocity = solver.superficial_velocity();
  m.flow_rate = solver.flow_rate();
  m.permeability = solver.permeability();
  if (m.critical.blocked && solver.flow_axis() >= 0) {
    // What the solver finds is its residual; superficial_velocity still shows it.
    m.flow_rate = 0.0;
    m.permeability = m.pressure_drop != 0.0 ? 0.0 : m.permeability;
  }
  m.body_force = solver.body_force();
  if (!has_resistance(problem)) {  // plug flow: the drop is 0, k unbounded
    m.pressure_drop = 0.0;
    m.permeability = std::numeric_limits<double>::infinity();
  }
  m.forces = wall_forces(solver);
  m.forces.spheres.resize(problem.spheres.size());  // bodies have their own
  m.regime = analyse_regime(scene, flow_scales(solver, m.flow_rate, m.critical.value));
  if (options.line) {
    m.profile = sample(solver, *options.line);
  }
  return m;
}

}  // namespace colloid
