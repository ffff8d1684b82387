// A path of points through a route of cells, and the clearance along it.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "observe/cell_tree.h"
#include "observe/widest_route.h"

namespace colloid {

/// A polygon through the points of largest clearance that were found on the gates between
/// the cells of a route; straight in each cell, where the surfaces that matter are known.
/// Its clearance is attained: a lower bound for the widest path.
struct Thread {
  std::vector<Vec3> points;            ///< [m]; on a period's far side, beyond the box
  std::vector<double> gate_clearance;  ///< on leaving cell i [m]
  std::vector<double> cell_clearance;  ///< on the way through cell i [m]
  double clearance = 0.0;              ///< the least of all [m]
  Vec3 narrowest;                      ///< where, in the box
  int narrowest_cell = -1;
};

/// Threads routes; remembers the points of gates that routes have in common.
class Threader {
 public:
  Threader(const CellTree& tree, std::vector<int> start_faces,
           std::vector<int> goal_faces)
      : tree_(tree),
        start_faces_(std::move(start_faces)),
        goal_faces_(std::move(goal_faces)) {}

  Thread thread(const Route& route);

 private:
  Summit gate(int cell, const Link& link);
  Summit rim(int cell, const std::vector<int>& faces);

  const CellTree& tree_;
  std::vector<int> start_faces_;
  std::vector<int> goal_faces_;
  std::unordered_map<std::uint64_t, Summit> gates_;
};

}  // namespace colloid
