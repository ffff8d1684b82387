#include "observe/widest_loop.h"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace colloid {

namespace {

/// Union-find in which every member knows its displacement from the root, in periods.
class WindingSets {
 public:
  explicit WindingSets(int count) : parent_(count), periods_(count, 0) {
    for (int i = 0; i < count; ++i) {
      parent_[i] = i;
    }
  }

  /// The root of a member and the member's periods from it.
  std::pair<int, int> root(int member) {
    int top = member;
    int total = 0;
    while (parent_[top] != top) {
      total += periods_[top];
      top = parent_[top];
    }
    for (int here = member, left = total; parent_[here] != here;) {
      const int next = parent_[here];
      const int step = periods_[here];
      parent_[here] = top;
      periods_[here] = left;
      left -= step;
      here = next;
    }
    return {top, total};
  }

  /// States that b lies `periods` beyond a; false if that contradicts what is known.
  bool join(int a, int b, int periods) {
    const auto [root_a, from_a] = root(a);
    const auto [root_b, from_b] = root(b);
    if (root_a == root_b) {
      return from_b - from_a == periods;
    }
    parent_[root_b] = root_a;
    periods_[root_b] = from_a + periods - from_b;
    return true;
  }

 private:
  std::vector<int> parent_;
  std::vector<int> periods_;
};

struct Visit {
  int from = -1;
  int periods = 0;
  bool reached = false;
  Link link;  // from `from`
};

int winding(const CellTree& tree, int cell, const Link& link, int axis) {
  return axis_of(link.face) == axis ? tree.crossing(cell, link) : 0;
}

std::vector<int> way_to(const std::vector<Visit>& visits, int cell) {
  std::vector<int> way;
  for (; cell >= 0; cell = visits[cell].from) {
    way.push_back(cell);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

Link reversed(const Link& link, int from) {
  return {from, link.face ^ 1};
}

// The loop that the link from a to b closes in a tree of visits.
Route close(const std::vector<Visit>& visits, int a, const Link& link) {
  const std::vector<int> to_a = way_to(visits, a);
  const std::vector<int> to_b = way_to(visits, link.cell);
  std::size_t common = 0;
  while (common + 1 < to_a.size() && common + 1 < to_b.size() &&
         to_a[common + 1] == to_b[common + 1]) {
    ++common;
  }
  Route route;
  for (std::size_t i = common; i < to_a.size(); ++i) {
    if (i > common) {
      route.exits.push_back(visits[to_a[i]].link);
    }
    route.cells.push_back(to_a[i]);
  }
  route.exits.push_back(link);
  for (std::size_t i = to_b.size() - 1; i > common; --i) {
    route.cells.push_back(to_b[i]);
    route.exits.push_back(reversed(visits[to_b[i]].link, to_b[i - 1]));
  }
  return route;
}

// Breadth first from the cell that closed a loop, among the cells that have joined.
Route trace(const CellTree& tree, const std::vector<char>& joined, int start, int axis) {
  std::vector<Visit> visits(static_cast<std::size_t>(tree.size()));
  std::queue<int> front;
  visits[start].reached = true;
  front.push(start);
  while (!front.empty()) {
    const int here = front.front();
    front.pop();
    for (const Link& link : tree[here].links) {
      if (joined[link.cell] == 0) {
        continue;
      }
      Visit& next = visits[link.cell];
      const int periods = visits[here].periods + winding(tree, here, link, axis);
      if (!next.reached) {
        next = {here, periods, true, link};
        front.push(link.cell);
      } else if (next.periods != periods) {
        return close(visits, here, link);
      }
    }
  }
  return {};
}

}  // namespace

Route widest_loop(CellTree& tree, int axis, double floor, double ceiling) {
  using Entry = std::pair<double, int>;
  std::vector<Entry> entries;
  for (int cell = 0; cell < tree.size(); ++cell) {
    if (tree[cell].is_leaf && tree[cell].upper > floor) {
      entries.emplace_back(tree[cell].upper, cell);
    }
  }
  std::priority_queue<Entry> heap(std::less<Entry>(), std::move(entries));
  WindingSets sets(tree.size());
  std::vector<char> joined(static_cast<std::size_t>(tree.size()), 0);
  while (!heap.empty()) {
    const auto [level, cell] = heap.top();
    heap.pop();
    tree.sharpen(cell, ceiling);
    if (tree[cell].upper < level) {
      if (tree[cell].upper > floor) {
        heap.emplace(tree[cell].upper, cell);
      }
      continue;
    }
    joined[cell] = 1;
    bool consistent = true;
    for (const Link& link : tree[cell].links) {
      if (joined[link.cell] != 0) {
        consistent =
            sets.join(cell, link.cell, winding(tree, cell, link, axis)) && consistent;
      }
    }
    if (!consistent) {
      Route route = trace(tree, joined, cell, axis);
      route.level = level;
      return route;
    }
  }
  return {};
}

}  // namespace colloid
