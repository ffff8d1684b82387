// From a scene to the question that the flow solver answers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "flow/stokes_problem.h"
#include "scene/scene.h"

namespace colloid {

/// How fine the grid is; at most one is given.
struct GridChoice {
  std::optional<double> cells_per_colloid;
  std::optional<double> cells_per_diameter;  ///< of the smallest sphere
  std::optional<std::array<int, 3>> cells;
};

/// Cells per axis.  Nothing given: the scene's cells_per_colloid; without colloids 24 per
/// diameter of the smallest sphere, 12 where bodies move; without spheres 48 along the
/// shortest edge.  Spacings are rounded so that whole cells fill each edge.  Refuses a
/// grid that this machine's memory cannot hold.
std::array<int, 3> choose_cells(const Scene& scene, const GridChoice& choice);

/// The scene's flow around its grains and `deposit`.
StokesProblem make_flow_problem(const Scene& scene, const std::vector<Sphere>& deposit,
                                const std::array<int, 3>& cells);

}  // namespace colloid
