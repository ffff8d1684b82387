#include "observe/thread.h"

#include <algorithm>
#include <limits>

namespace colloid {

namespace {

struct Narrowest {
  double clearance = std::numeric_limits<double>::infinity();
  Vec3 point;
};

Narrowest along(const CellTree& tree, int cell, const Vec3& from, const Vec3& to) {
  Narrowest least;
  for (int i = 0; i < tree[cell].count; ++i) {
    const Surface& surface = tree.surfaces()[tree.surfaces_in(cell)[i]];
    const SegmentDistance nearest = segment_distance(surface, from, to);
    if (nearest.value < least.clearance) {
      least = {nearest.value, from + nearest.fraction * (to - from)};
    }
  }
  return least;
}

// Cells stay below 2^30; on a face of the box the cell is its own neighbour.
std::uint64_t gate_key(int cell, int neighbour, int face) {
  return (static_cast<std::uint64_t>(cell) << 34) |
         (static_cast<std::uint64_t>(neighbour) << 3) | static_cast<std::uint64_t>(face);
}

}  // namespace

Summit Threader::gate(int cell, const Link& link) {
  const std::uint64_t key = gate_key(cell, link.cell, link.face);
  const auto [known, is_new] = gates_.try_emplace(key);
  if (is_new) {
    known->second = climb(tree_.surfaces(), tree_.surfaces_in(cell), tree_[cell].count,
                          tree_.gate(cell, link));
  }
  return known->second;
}

// The best point of a cell on one of the faces of the box.
Summit Threader::rim(int cell, const std::vector<int>& faces) {
  Summit best;
  best.clearance = -std::numeric_limits<double>::infinity();
  for (const int face : faces) {
    if (tree_.touches(cell, face)) {
      const auto [known, is_new] = gates_.try_emplace(gate_key(cell, cell, face));
      if (is_new) {
        known->second = climb(tree_.surfaces(), tree_.surfaces_in(cell),
                              tree_[cell].count, tree_.rim(cell, face));
      }
      const Summit& summit = known->second;
      if (summit.clearance > best.clearance) {
        best = summit;
      }
    }
  }
  return best;
}

Thread Threader::thread(const Route& route) {
  const bool closed = route.exits.size() == route.cells.size();
  std::vector<Summit> exits;
  std::vector<Vec3> shift;  // in periods, from a cell to the next
  for (std::size_t i = 0; i < route.exits.size(); ++i) {
    const int cell = route.cells[i];
    const Link& link = route.exits[i];
    exits.push_back(gate(cell, link));
    Vec3 periods;
    const int axis = axis_of(link.face);
    periods[axis] = tree_.crossing(cell, link) * tree_.box().size[axis];
    shift.push_back(periods);
  }
  if (!closed) {
    exits.push_back(rim(route.cells.back(), goal_faces_));
    shift.emplace_back();
  }
  Thread result;
  result.clearance = std::numeric_limits<double>::infinity();
  Vec3 at = closed ? exits.back().point - shift.back()
                   : rim(route.cells.front(), start_faces_).point;
  Vec3 offset;
  result.points.push_back(at);
  for (std::size_t i = 0; i < route.cells.size(); ++i) {
    const Narrowest least = along(tree_, route.cells[i], at, exits[i].point);
    result.gate_clearance.push_back(exits[i].clearance);
    result.cell_clearance.push_back(least.clearance);
    if (least.clearance < result.clearance) {
      result.clearance = least.clearance;
      result.narrowest = least.point;
      result.narrowest_cell = route.cells[i];
    }
    result.points.push_back(exits[i].point + offset);
    offset += shift[i];
    at = exits[i].point - shift[i];
  }
  return result;
}

}  // namespace colloid
