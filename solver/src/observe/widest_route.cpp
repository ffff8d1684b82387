#include "observe/widest_route.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace colloid {

Flood::Flood(CellTree& tree, std::vector<int> start_faces, std::vector<int> goal_faces)
    : tree_(tree),
      start_faces_(std::move(start_faces)),
      goal_faces_(std::move(goal_faces)),
      visits_(static_cast<std::size_t>(tree.size())) {
  for (int cell = 0; cell < tree_.size(); ++cell) {
    reach(cell);
  }
}

bool Flood::touches_any(int cell, const std::vector<int>& faces) const {
  return std::any_of(faces.begin(), faces.end(),
                     [&](int face) { return tree_.touches(cell, face); });
}

void Flood::push(double level, int cell, int from) {
  const int stamp = from < 0 ? 0 : visits_[static_cast<std::size_t>(from)].stamp;
  heap_.push_back({std::min(level, tree_[cell].upper), cell, from, stamp});
  std::push_heap(heap_.begin(), heap_.end());
}

// Queues a cell that is not visited from the start and from its visited neighbours.
void Flood::reach(int cell) {
  if (touches_any(cell, start_faces_)) {
    push(std::numeric_limits<double>::infinity(), cell, -1);
  }
  for (const Link& link : tree_[cell].links) {
    if (visited(link.cell)) {
      push(visits_[static_cast<std::size_t>(link.cell)].level, cell, link.cell);
    }
  }
}

Route Flood::find(double floor, double ceiling) {
  while (!heap_.empty() && heap_.front().level > floor) {
    const Entry top = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    const bool stale =
        top.from >= 0 && visits_[static_cast<std::size_t>(top.from)].stamp != top.stamp;
    if (stale || visited(top.cell) || !tree_[top.cell].is_leaf) {
      continue;
    }
    tree_.sharpen(top.cell, ceiling);
    if (tree_[top.cell].upper < top.level) {
      push(top.level, top.cell, top.from);
      continue;
    }
    visits_[static_cast<std::size_t>(top.cell)] = {top.level, top.from, ++stamp_};
    for (const Link& link : tree_[top.cell].links) {
      if (!visited(link.cell)) {
        push(top.level, link.cell, top.cell);
      }
    }
    if (touches_any(top.cell, goal_faces_)) {
      return trace(top.cell);
    }
  }
  return {};
}

// The cells whose way passes `cell`, itself included, are no longer visited.
std::vector<int> Flood::forget(int cell) {
  std::vector<int> forgotten = {cell};
  visits_[static_cast<std::size_t>(cell)].stamp = 0;
  for (std::size_t i = 0; i < forgotten.size(); ++i) {
    const int here = forgotten[i];
    for (const Link& link : tree_[here].links) {
      Visit& next = visits_[static_cast<std::size_t>(link.cell)];
      if (next.stamp > 0 && next.from == here) {
        next.stamp = 0;
        forgotten.push_back(link.cell);
      }
    }
  }
  return forgotten;
}

void Flood::split(int cell, double floor) {
  const std::vector<int> forgotten = forget(cell);
  const int first = tree_.split(cell, floor);
  visits_.resize(static_cast<std::size_t>(tree_.size()));
  for (const int other : forgotten) {
    if (tree_[other].is_leaf) {
      reach(other);
    }
  }
  for (int child = first; child < tree_.size(); ++child) {
    reach(child);
  }
}

Route Flood::trace(int goal) const {
  Route route;
  route.level = visits_[static_cast<std::size_t>(goal)].level;
  for (int cell = goal; cell >= 0; cell = visits_[static_cast<std::size_t>(cell)].from) {
    route.cells.push_back(cell);
  }
  std::reverse(route.cells.begin(), route.cells.end());
  for (std::size_t i = 0; i + 1 < route.cells.size(); ++i) {
    const auto& links = tree_[route.cells[i]].links;
    const auto exit = std::find_if(links.begin(), links.end(), [&](const Link& link) {
      return link.cell == route.cells[i + 1];
    });
    route.exits.push_back(*exit);
  }
  return route;
}

}  // namespace colloid
