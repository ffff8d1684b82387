// The route of cells whose smallest upper bound is largest, kept up to date while cells
// split.
#pragma once

#include <vector>

#include "observe/cell_tree.h"

namespace colloid {

/// Cells one after the other; `exits[i]` leads from cells[i] to cells[i + 1], and for a
/// closed route the last one back to cells[0].
struct Route {
  double level = 0.0;  ///< the smallest upper bound on it [m]; no route has a larger one
  std::vector<int> cells;
  std::vector<Link> exits;

  bool empty() const { return cells.empty(); }
};

/// Finds the widest route from the start faces to the goal faces.
///
/// Prim's algorithm: cells are taken in order of the smallest upper bound on their way
/// from the start.  Splitting a cell only lowers bounds, so the ways that do not pass the
/// cell stay the widest: only those that do are forgotten and found anew.  (A new search
/// per split would cost the number of cells, thousands, times the number of splits.)
class Flood {
 public:
  Flood(CellTree& tree, std::vector<int> start_faces, std::vector<int> goal_faces);

  /// The widest route, empty if no cell with a bound above `floor` [m] leads to the goal.
  /// It is known to be at most `ceiling` [m] wide.
  Route find(double floor, double ceiling);
  /// Splits a cell and forgets the ways through it.
  void split(int cell, double floor);

 private:
  struct Entry {
    double level;
    int cell;
    int from;   // -1: the start
    int stamp;  // of `from` when the entry was made
    bool operator<(const Entry& other) const { return level < other.level; }
  };
  struct Visit {
    double level = 0.0;
    int from = -1;
    int stamp = 0;  // 0: not visited
  };

  bool touches_any(int cell, const std::vector<int>& faces) const;
  bool visited(int cell) const {
    return visits_[static_cast<std::size_t>(cell)].stamp > 0;
  }
  void push(double level, int cell, int from);
  void reach(int cell);
  std::vector<int> forget(int cell);
  Route trace(int goal) const;

  CellTree& tree_;
  std::vector<int> start_faces_;
  std::vector<int> goal_faces_;
  std::vector<Visit> visits_;
  std::vector<Entry> heap_;
  int stamp_ = 0;
};

}  // namespace colloid
