#include "tiers/flow_scales.h"

#include <cmath>

namespace colloid {

FlowScales flow_scales(const StokesSolver& solver, double flow_rate,
                       double critical_diameter) {
  const StokesProblem& problem = solver.problem();
  FlowScales scales;
  scales.largest_speed = solver.largest_speed();
  scales.throat_diameter = critical_diameter;
  const int axis = solver.flow_axis();
  if (axis < 0) {
    // Sheared, not driven through: the largest speed is the only scale there is.
    scales.inlet_speed = scales.largest_speed;
    scales.throat_speed = scales.largest_speed;
    return scales;
  }
  const double area = problem.box.size[(axis + 1) % 3] * problem.box.size[(axis + 2) % 3];
  scales.inlet_speed = std::abs(flow_rate) / area;
  const double open = narrowest_open_area(problem.box, problem.spheres, axis);
  scales.throat_speed = open > 0.0 ? std::abs(flow_rate) / open : 0.0;
  return scales;
}

}  // namespace colloid
