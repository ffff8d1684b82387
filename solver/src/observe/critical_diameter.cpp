#include "observe/critical_diameter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "observe/cell_tree.h"
#include "observe/thread.h"
#include "observe/widest_loop.h"
#include "observe/widest_route.h"

namespace colloid {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Where paths begin and end; a period has neither.
struct Passage {
  std::vector<int> start;
  std::vector<int> goal;
  int period_axis = -1;
};

Passage passage_of(const Box& box, int flow_axis) {
  Passage passage;
  for (int face = 0; face < kFaces; ++face) {
    if (box.face(face) == FaceCondition::inlet) {
      passage.start.push_back(face);
    } else if (box.face(face) == FaceCondition::outlet) {
      passage.goal.push_back(face);
    }
  }
  if (!passage.start.empty() && !passage.goal.empty()) {
    return passage;
  }
  if (box.periodic(flow_axis)) {
    return {{}, {}, flow_axis};
  }
  return {{2 * flow_axis}, {2 * flow_axis + 1}, -1};
}

double reference_length(const Box& box, const std::vector<Sphere>& spheres) {
  const double edge = std::min({box.size.x, box.size.y, box.size.z});
  double length = edge;
  for (const Sphere& sphere : spheres) {
    length = std::min(length, 2.0 * sphere.radius);
  }
  constexpr double kLeast = 1e-6;  // of the edge: a dust grain must not set the tolerance
  return std::max(length, kLeast * edge);
}

/// Brackets half of l_c between the clearance of a thread and the level of a route.
class Search {
 public:
  Search(const Box& box, std::vector<Surface> surfaces, const Passage& passage,
         double tolerance, double above)
      : tree_(box, std::move(surfaces)),
        threader_(tree_, passage.start, passage.goal),
        period_axis_(passage.period_axis),
        tolerance_(tolerance),
        below_(tolerance),
        above_(above) {
    if (period_axis_ < 0) {
      flood_ = std::make_unique<Flood>(tree_, passage.start, passage.goal);
    }
  }

  void run(int most_cells) {
    while (tree_.size() < most_cells) {
      const Route route = flood_ ? flood_->find(below_, above_)
                                 : widest_loop(tree_, period_axis_, below_, above_);
      if (route.empty()) {
        above_ = below_;
        return;
      }
      above_ = std::min(above_, route.level);
      Thread thread = threader_.thread(route);
      if (thread.clearance > below_) {
        below_ = thread.clearance;
        best_ = thread;
      }
      if (above_ - below_ <= tolerance_ || !refine(route, thread)) {
        return;
      }
    }
  }

  double below() const { return below_; }
  double above() const { return std::max(above_, below_); }
  const Thread& best() const { return best_; }
  const CellTree& tree() const { return tree_; }

 private:
  bool split(int cell) {
    if (!tree_[cell].is_leaf || !tree_.can_split(cell)) {
      return !tree_[cell].is_leaf;
    }
    if (flood_) {
      flood_->split(cell, below_);
    } else {
      tree_.split(cell, below_);
    }
    return true;
  }

  double width(int cell) const {
    const Extent e = tree_.extent(cell);
    return norm(e.hi - e.lo);
  }

  // Splits what keeps the thread below the middle of the bracket, and at the least the
  // narrowest cell.  False if nothing can be split.
  bool refine(const Route& route, const Thread& thread) {
    const double middle = 0.5 * (above_ + below_);
    std::vector<int> wanted = {thread.narrowest_cell};
    for (std::size_t i = 0; i < route.cells.size(); ++i) {
      const int cell = route.cells[i];
      if (i < route.exits.size() && thread.gate_clearance[i] < middle) {
        const int next = route.exits[i].cell;
        const double here = width(cell);
        const double there = width(next);
        if (here > 0.9 * there) {
          wanted.push_back(cell);
        }
        if (there > 0.9 * here) {
          wanted.push_back(next);
        }
      } else if (thread.cell_clearance[i] < middle) {
        wanted.push_back(cell);
      }
    }
    bool any = false;
    for (const int cell : wanted) {
      any = split(cell) || any;
    }
    return any;
  }

  CellTree tree_;
  Threader threader_;
  int period_axis_;
  std::unique_ptr<Flood> flood_;
  double tolerance_;
  double below_;
  double above_;
  Thread best_;
};

// The surfaces whose distance from the point is the least one, to the accuracy with which
// a bottleneck is located: the root of the accuracy of its clearance.
std::vector<SurfaceName> nearest_surfaces(const CellTree& tree, const Thread& thread,
                                          double slack) {
  std::vector<SurfaceName> names;
  const int cell = thread.narrowest_cell;
  for (int i = 0; cell >= 0 && i < tree[cell].count; ++i) {
    const Surface& surface = tree.surfaces()[tree.surfaces_in(cell)[i]];
    if (distance(surface, thread.narrowest) <= thread.clearance + slack) {
      names.push_back(surface.name);
    }
  }
  return names;
}

double clearance_along(const Box& box, const std::vector<Surface>& surfaces,
                       const std::vector<Vec3>& path) {
  double least = kInfinite;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 middle = 0.5 * (path[i] + path[i + 1]);
    const Vec3 shift = wrapped(box, middle) - middle;
    for (const Surface& surface : surfaces) {
      least = std::min(
          least, segment_distance(surface, path[i] + shift, path[i + 1] + shift).value);
    }
  }
  return least;
}

}  // namespace

CriticalDiameter critical_diameter(const Box& box, const std::vector<Sphere>& spheres,
                                   const CriticalDiameterOptions& options) {
  const Passage passage = passage_of(box, options.flow_axis);
  std::vector<int> open = passage.start;
  open.insert(open.end(), passage.goal.begin(), passage.goal.end());
  std::vector<Surface> surfaces = surfaces_of(box, spheres, open);
  CriticalDiameter result;
  if (surfaces.empty()) {
    result.value = kInfinite;
    return result;
  }
  const double reference = reference_length(box, spheres);
  const double tolerance = 0.25 * options.tolerance * reference;
  double above = kInfinite;
  if (options.before != nullptr) {
    const CriticalDiameter& before = *options.before;
    constexpr double kRounding = 1e-12;
    const double still = 2.0 * clearance_along(box, surfaces, before.path);
    if (before.blocked || still >= before.value * (1.0 - kRounding)) {
      return before;
    }
    above = 0.5 * (before.value + before.error);
  }
  Search search(box, std::move(surfaces), passage, tolerance, above);
  search.run(options.most_cells);
  result.cells = search.tree().size();
  result.error = 2.0 * (search.above() - search.below());
  if (search.best().points.empty()) {
    result.error = 2.0 * search.above();
    result.blocked = search.above() <= 2.0 * tolerance;
    return result;
  }
  result.value = 2.0 * search.below();
  result.bottleneck = wrapped(box, search.best().narrowest);
  const double slack = std::sqrt(options.tolerance) * reference;
  result.surfaces = nearest_surfaces(search.tree(), search.best(), slack);
  result.path = search.best().points;
  return result;
}

}  // namespace colloid
