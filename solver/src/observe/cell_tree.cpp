#include "observe/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace colloid {

namespace {

constexpr std::int64_t kFull = std::int64_t{1} << CellTree::kDepth;

constexpr int opposite(int face) {
  return face ^ 1;
}

}  // namespace

CellTree::CellTree(const Box& box, std::vector<Surface> surfaces)
    : box_(box), surfaces_(std::move(surfaces)) {
  make_coarse_grid();
}

Extent CellTree::extent(int cell) const {
  const Cell& c = (*this)[cell];
  Extent e;
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = box_.size[axis] / static_cast<double>(kFull);
    e.lo[axis] = unit * static_cast<double>(c.lo[axis]);
    e.hi[axis] = unit * static_cast<double>(c.lo[axis] + c.size[axis]);
  }
  return e;
}

Extent CellTree::rim(int cell, int face) const {
  Extent e = extent(cell);
  const int axis = axis_of(face);
  e.lo[axis] = e.hi[axis] = is_upper(face) ? e.hi[axis] : e.lo[axis];
  return e;
}

Extent CellTree::gate(int cell, const Link& link) const {
  Extent e = rim(cell, link.face);
  const Extent other = extent(link.cell);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != axis_of(link.face)) {
      e.lo[axis] = std::max(e.lo[axis], other.lo[axis]);
      e.hi[axis] = std::min(e.hi[axis], other.hi[axis]);
    }
  }
  return e;
}

bool CellTree::touches(int cell, int face) const {
  const Cell& c = (*this)[cell];
  const int axis = axis_of(face);
  return is_upper(face) ? c.lo[axis] + c.size[axis] == kFull : c.lo[axis] == 0;
}

int CellTree::crossing(int cell, const Link& link) const {
  if (!touches(cell, link.face)) {
    return 0;
  }
  return is_upper(link.face) ? 1 : -1;
}

void CellTree::sharpen(int cell, double ceiling) {
  Cell& c = cells_[static_cast<std::size_t>(cell)];
  if (c.sharp) {
    return;
  }
  const Extent e = extent(cell);
  const Vec3 center = e.center();
  double attained = std::numeric_limits<double>::infinity();
  for (int i = 0; i < c.count && attained > ceiling; ++i) {
    attained = std::min(attained, distance(surfaces_[surfaces_in(cell)[i]], center));
  }
  if (attained <= ceiling) {
    const double bound = upper_clearance(surfaces_, surfaces_in(cell), c.count, e);
    c.upper = std::min(c.upper, bound);
    c.sharp = true;
  }
}

bool CellTree::can_split(int cell) const {
  const Cell& c = (*this)[cell];
  return std::min({c.size[0], c.size[1], c.size[2]}) > 1;
}

// Appends the cell unless its clearance is at most the floor.
void CellTree::add(const Cell& cell, const int* some, int count, double floor) {
  const int index = size();
  const auto start = near_.size();
  cells_.push_back(cell);
  const Extent e = extent(index);
  double upper = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count && upper > floor; ++i) {
    upper = std::min(upper, largest_distance(surfaces_[some[i]], e));
  }
  if (upper <= floor) {
    cells_.pop_back();
    return;
  }
  for (int i = 0; i < count; ++i) {
    if (least_distance(surfaces_[some[i]], e) <= upper) {
      near_.push_back(some[i]);
    }
  }
  Cell& added = cells_.back();
  added.upper = upper;
  added.first = static_cast<int>(start);
  added.count = static_cast<int>(near_.size() - start);
}

// `face` is the one of cell `a` through which b is to be reached.
void CellTree::link_if_adjacent(int a, int b, int face) {
  Cell& from = cells_[static_cast<std::size_t>(a)];
  Cell& to = cells_[static_cast<std::size_t>(b)];
  const int axis = axis_of(face);
  const std::int64_t exit =
      is_upper(face) ? from.lo[axis] + from.size[axis] : from.lo[axis];
  const std::int64_t entry = is_upper(face) ? to.lo[axis] : to.lo[axis] + to.size[axis];
  const bool wraps = box_.periodic(axis) && exit == (is_upper(face) ? kFull : 0) &&
                     entry == kFull - exit;
  if (exit != entry && !wraps) {
    return;
  }
  for (int i = 0; i < 3; ++i) {
    if (i != axis &&
        (from.lo[i] >= to.lo[i] + to.size[i] || to.lo[i] >= from.lo[i] + from.size[i])) {
      return;
    }
  }
  from.links.push_back({b, face});
  to.links.push_back({a, opposite(face)});
}

// At least two cells on each axis, so that no cell is its own periodic neighbour, and
// about as wide as long.
void CellTree::make_coarse_grid() {
  constexpr double kOnShortest = 4.0;
  constexpr double kMost = 64.0;
  const double shortest = std::min({box_.size.x, box_.size.y, box_.size.z});
  std::array<std::int64_t, 3> cells = {};
  for (int axis = 0; axis < 3; ++axis) {
    const double wanted = std::min(kMost, kOnShortest * box_.size[axis] / shortest);
    cells[axis] = std::int64_t{1} << std::lround(std::log2(wanted));
  }
  std::vector<int> every(surfaces_.size());
  std::iota(every.begin(), every.end(), 0);
  const auto count = static_cast<int>(every.size());
  const double lowest = -std::numeric_limits<double>::infinity();
  for (std::int64_t k = 0; k < cells[2]; ++k) {
    for (std::int64_t j = 0; j < cells[1]; ++j) {
      for (std::int64_t i = 0; i < cells[0]; ++i) {
        Cell cell;
        cell.size = {kFull / cells[0], kFull / cells[1], kFull / cells[2]};
        cell.lo = {i * cell.size[0], j * cell.size[1], k * cell.size[2]};
        add(cell, every.data(), count, lowest);
      }
    }
  }
  const std::array<std::int64_t, 3> stride = {1, cells[0], cells[0] * cells[1]};
  for (int a = 0; a < size(); ++a) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool last = touches(a, 2 * axis + 1);
      const std::int64_t b =
          last ? a - (cells[axis] - 1) * stride[axis] : a + stride[axis];
      if (!last || box_.periodic(axis)) {
        link_if_adjacent(a, static_cast<int>(b), 2 * axis + 1);
      }
    }
  }
}

int CellTree::split(int cell, double floor) {
  constexpr double kLong = 0.6;  // of the longest side: such sides are halved
  const Cell parent = (*this)[cell];
  const Extent e = extent(cell);
  const Vec3 side = e.hi - e.lo;
  const double longest = std::max({side.x, side.y, side.z});
  std::array<int, 3> parts = {};
  Cell shape;
  for (int axis = 0; axis < 3; ++axis) {
    parts[axis] = side[axis] > kLong * longest ? 2 : 1;
    shape.size[axis] = parent.size[axis] / parts[axis];
  }
  const std::vector<int> some(surfaces_in(cell), surfaces_in(cell) + parent.count);
  const int first = size();
  for (int k = 0; k < parts[2]; ++k) {
    for (int j = 0; j < parts[1]; ++j) {
      for (int i = 0; i < parts[0]; ++i) {
        shape.lo = {parent.lo[0] + i * shape.size[0], parent.lo[1] + j * shape.size[1],
                    parent.lo[2] + k * shape.size[2]};
        add(shape, some.data(), parent.count, floor);
      }
    }
  }
  for (const Link& link : parent.links) {
    auto& back = cells_[static_cast<std::size_t>(link.cell)].links;
    back.erase(std::remove_if(back.begin(), back.end(),
                              [&](const Link& l) { return l.cell == cell; }),
               back.end());
  }
  for (int child = first; child < size(); ++child) {
    cells_[static_cast<std::size_t>(child)].upper =
        std::min(cells_[static_cast<std::size_t>(child)].upper, parent.upper);
    for (const Link& link : parent.links) {
      link_if_adjacent(child, link.cell, link.face);
    }
    for (int sibling = first; sibling < child; ++sibling) {
      for (int face = 0; face < kFaces; ++face) {
        link_if_adjacent(child, sibling, face);
      }
    }
  }
  Cell& spent = cells_[static_cast<std::size_t>(cell)];
  spent.is_leaf = false;
  spent.links = {};
  return first;
}

}  // namespace colloid
