#include "grid_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace colloid {

namespace {

class Grid {
 public:
  Grid(const Packing& packing, int per_edge) : box_(packing.box) {
    const double edge = std::min({box_.size.x, box_.size.y, box_.size.z});
    for (int axis = 0; axis < 3; ++axis) {
      const double wanted = per_edge * box_.size[axis] / edge;
      const auto intervals = static_cast<int>(std::ceil(wanted - 1e-9));
      spacing_[axis] = box_.size[axis] / intervals;
      points_[axis] = box_.periodic(axis) ? intervals : intervals + 1;
    }
    clearance_.resize(static_cast<std::size_t>(points_[0]) * points_[1] * points_[2]);
    for (int k = 0; k < points_[2]; ++k) {
      for (int j = 0; j < points_[1]; ++j) {
        for (int i = 0; i < points_[0]; ++i) {
          const Vec3 point{i * spacing_.x, j * spacing_.y, k * spacing_.z};
          clearance_[index({i, j, k})] = static_cast<float>(clearance_at(packing, point));
        }
      }
    }
  }

  const Vec3& spacing() const { return spacing_; }

  // Whether points of at least this clearance lead from top to bottom, or once around z.
  bool percolates(float clearance) const {
    std::vector<int> turns(clearance_.size(), kUnseen);
    std::vector<std::array<int, 3>> stack;
    const bool around = box_.periodic(2);
    for (int k = around ? 0 : points_[2] - 1; k < points_[2]; ++k) {
      for (int j = 0; j < points_[1]; ++j) {
        for (int i = 0; i < points_[0]; ++i) {
          if (turns[index({i, j, k})] != kUnseen ||
              clearance_[index({i, j, k})] < clearance) {
            continue;
          }
          turns[index({i, j, k})] = 0;
          stack.push_back({i, j, k});
          if (flood(clearance, turns, stack)) {
            return true;
          }
        }
      }
    }
    return false;
  }

 private:
  static constexpr int kUnseen = std::numeric_limits<int>::max();

  std::size_t index(const std::array<int, 3>& p) const {
    return (static_cast<std::size_t>(p[2]) * points_[1] + p[1]) * points_[0] + p[0];
  }

  double clearance_at(const Packing& packing, const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (box_.face(2 * axis) == FaceCondition::wall) {
        least = std::min(least, point[axis]);
      }
      if (box_.face(2 * axis + 1) == FaceCondition::wall) {
        least = std::min(least, box_.size[axis] - point[axis]);
      }
    }
    for (const Sphere& sphere : packing.spheres) {
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        double apart = std::abs(point[axis] - sphere.center[axis]);
        if (box_.periodic(axis)) {
          apart = std::fmod(apart, box_.size[axis]);
          apart = std::min(apart, box_.size[axis] - apart);
        }
        square += apart * apart;
      }
      least = std::min(least, std::sqrt(square) - sphere.radius);
    }
    return least;
  }

  // True when the bottom is reached, or a point is met with a different count of turns.
  bool flood(float clearance, std::vector<int>& turns,
             std::vector<std::array<int, 3>>& stack) const {
    while (!stack.empty()) {
      const std::array<int, 3> here = stack.back();
      stack.pop_back();
      if (!box_.periodic(2) && here[2] == 0) {
        return true;
      }
      for (int step = 0; step < 6; ++step) {
        const int axis = step / 2;
        std::array<int, 3> next = here;
        int turn = turns[index(here)];
        int& moved = next[static_cast<std::size_t>(axis)];
        moved += step % 2 == 0 ? -1 : 1;
        if (moved < 0 || moved >= points_[axis]) {
          if (!box_.periodic(axis)) {
            continue;
          }
          turn += axis == 2 ? (moved < 0 ? -1 : 1) : 0;
          moved = (moved + points_[axis]) % points_[axis];
        }
        int& known = turns[index(next)];
        if (clearance_[index(next)] < clearance) {
          continue;
        }
        if (known == kUnseen) {
          known = turn;
          stack.push_back(next);
        } else if (box_.periodic(2) && known != turn) {
          return true;
        }
      }
    }
    return false;
  }

  Box box_;
  Vec3 spacing_;
  std::array<int, 3> points_ = {};
  std::vector<float> clearance_;
};

}  // namespace

Bracket grid_critical_diameter(const Packing& packing, int per_edge) {
  const Grid grid(packing, per_edge);
  const double edge =
      std::max({packing.box.size.x, packing.box.size.y, packing.box.size.z});
  auto low = static_cast<float>(-edge);
  auto high = static_cast<float>(edge);
  constexpr int kHalvings = 22;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5F * (low + high);
    (grid.percolates(middle) ? low : high) = middle;
  }
  const Vec3 s = grid.spacing();
  const double single_precision = 1e-6 * edge;
  return {2.0 * low - std::max({s.x, s.y, s.z}) - single_precision,
          2.0 * high + norm(s) + single_precision};
}

}  // namespace colloid
