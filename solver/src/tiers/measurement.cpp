#include "tiers/measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "flow/interpolation.h"

namespace colloid {

namespace {

FlowScales flow_scales(const StokesSolver& solver, double critical_diameter) {
  const StokesProblem& problem = solver.problem();
  FlowScales scales;
  scales.largest_speed = solver.largest_speed();
  scales.throat_diameter = critical_diameter;
  const int axis = solver.flow_axis();
  if (axis < 0) {
    return scales;
  }
  const double area = problem.box.size[(axis + 1) % 3] * problem.box.size[(axis + 2) % 3];
  scales.inlet_speed = std::abs(solver.flow_rate()) / area;
  const double open = narrowest_open_area(problem.box, problem.spheres, axis);
  scales.throat_speed = open > 0.0 ? std::abs(solver.flow_rate()) / open : 0.0;
  return scales;
}

std::vector<ProfilePoint> sample(const StokesSolver& solver, const Line& line) {
  std::vector<ProfilePoint> points;
  for (int n = 0; n < line.points; ++n) {
    const double t = static_cast<double>(n) / (line.points - 1);
    const Vec3 x = line.begin * (1.0 - t) + line.end * t;
    points.push_back({x, velocity_at(solver, x)});
  }
  return points;
}

}  // namespace

Measurement measure(const Scene& scene, const MeasureOptions& options) {
  Measurement m;
  m.cells = choose_cells(scene, options.grid);
  const StokesProblem problem = make_flow_problem(scene, options.deposit, m.cells);
  for (int a = 0; a < 3; ++a) {
    m.spacing[a] = problem.box.size[a] / m.cells[static_cast<std::size_t>(a)];
  }

  StokesOptions flow;
  flow.tolerance = scene.fidelity.tolerance;
  flow.threads = options.threads;
  CriticalDiameterOptions search;
  search.flow_axis = std::max(0, flow_axis(problem));
  m.critical = critical_diameter(problem.box, problem.spheres, search);
  require(
      !m.critical.blocked || problem.drive.kind != FlowDrive::Kind::inlet_velocity,
      "/drive/inlet_velocity",
      "the way from the inlet to the outlet is blocked (critical diameter 0), no flux "
      "can be held; expected a pressure_drop");

  StokesSolver solver(problem, flow);
  m.statistics = solver.solve();
  m.pressure_drop = solver.pressure_drop();
  m.flow_rate = solver.flow_rate();
  m.superficial_velocity = solver.superficial_velocity();
  m.permeability = solver.permeability();
  m.body_force = solver.body_force();
  m.forces = wall_forces(solver);
  m.regime = analyse_regime(scene, flow_scales(solver, m.critical.value));
  if (options.line) {
    m.profile = sample(solver, *options.line);
  }
  return m;
}

}  // namespace colloid
