// The box cut into cells, each with the surfaces that can be nearest in it, its
// neighbours, and an upper bound of the clearance in it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "observe/max_min.h"
#include "observe/surface.h"

namespace colloid {

/// A face-neighbour of a cell.
struct Link {
  int cell = -1;
  int face = 0;  ///< of the linking cell, towards the neighbour
};

struct Cell {
  std::array<std::int64_t, 3> lo = {};    ///< in units of the box size / 2^kDepth
  std::array<std::int64_t, 3> size = {};  ///< powers of two
  double upper = 0.0;                     ///< bound of the clearance in the cell [m]
  bool sharp = false;                     ///< `upper` is of second order (max_min.h)
  bool is_leaf = true;
  int first = 0;  ///< of its surfaces in the tree's list
  int count = 0;
  std::vector<Link> links;
};

class CellTree {
 public:
  static constexpr int kDepth = 40;

  CellTree(const Box& box, std::vector<Surface> surfaces);

  const Box& box() const { return box_; }
  const std::vector<Surface>& surfaces() const { return surfaces_; }
  int size() const { return static_cast<int>(cells_.size()); }
  const Cell& operator[](int cell) const {
    return cells_[static_cast<std::size_t>(cell)];
  }
  const int* surfaces_in(int cell) const { return near_.data() + (*this)[cell].first; }

  Extent extent(int cell) const;
  /// The rectangle that a cell shares with a neighbour, on the side of the cell.
  Extent gate(int cell, const Link& link) const;
  /// The part of a face of the box that belongs to the cell.
  Extent rim(int cell, int face) const;
  bool touches(int cell, int face) const;
  /// Whether stepping through the link crosses a periodic face, and that shift in
  /// periods.
  int crossing(int cell, const Link& link) const;

  /// Brings `upper` to second order, unless it would stay above `ceiling` [m] anyway.
  void sharpen(int cell, double ceiling);
  bool can_split(int cell) const;
  /// Replaces a leaf by its children, halved along its long sides; those whose clearance
  /// cannot exceed `floor` [m] are dropped.  Returns the first child; the rest follow it.
  int split(int cell, double floor);

 private:
  void add(const Cell& cell, const int* some, int count, double floor);
  void link_if_adjacent(int a, int b, int face);
  void make_coarse_grid();

  Box box_;
  std::vector<Surface> surfaces_;
  std::vector<Cell> cells_;
  std::vector<int> near_;
};

}  // namespace colloid
