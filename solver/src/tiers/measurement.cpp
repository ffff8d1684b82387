#include "tiers/measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "flow/interpolation.h"
#include "tiers/flow_scales.h"

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

  StokesSolver solver(problem, flow);
  m.statistics = solver.solve();
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
  m.regime = analyse_regime(scene, flow_scales(solver, m.flow_rate, m.critical.value));
  if (options.line) {
    m.profile = sample(solver, *options.line);
  }
  return m;
}

}  // namespace colloid
