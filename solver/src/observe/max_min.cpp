#include "observe/max_min.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace colloid {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// A programme's basis: `count` surfaces with weight, and count - 1 axes on which their
// weighted gradients cancel.
struct Basis {
  int count = 0;
  std::array<int, 4> member = {};
  std::array<int, 3> axis = {};
  std::array<double, 4> weight = {};
  Vec3 sum;  // of weighted gradients
  double optimum = kInfinite;
};

double minor2(const Vec3& a, const Vec3& b, int i, int j) {
  return a[i] * b[j] - a[j] * b[i];
}

// Weights that cancel the gradients on the axes of the basis, up to a factor: Cramer's
// rule.
void cancelling_weights(const std::array<Vec3, 4>& g, Basis& basis) {
  const int i = basis.axis[0];
  const int j = basis.axis[1];
  if (basis.count == 1) {
    basis.weight = {1.0, 0.0, 0.0, 0.0};
  } else if (basis.count == 2) {
    basis.weight = {g[1][i], -g[0][i], 0.0, 0.0};
  } else if (basis.count == 3) {
    basis.weight = {minor2(g[1], g[2], i, j), minor2(g[2], g[0], i, j),
                    minor2(g[0], g[1], i, j), 0.0};
  } else {
    basis.weight = {dot(g[1], cross(g[2], g[3])), -dot(g[0], cross(g[2], g[3])),
                    dot(g[0], cross(g[1], g[3])), -dot(g[0], cross(g[1], g[2]))};
  }
}

// The dual weights of a basis and their optimum; false if they are not all of one sign.
bool weigh(const LinearMaxMin& lp, Basis& basis) {
  constexpr double kSingular = 1e-13;  // gradients have length one
  std::array<Vec3, 4> g;
  for (int s = 0; s < basis.count; ++s) {
    g[s] = lp.gradient[basis.member[s]];
  }
  cancelling_weights(g, basis);
  double total = 0.0;
  double magnitude = 0.0;
  for (int s = 0; s < basis.count; ++s) {
    total += basis.weight[s];
    magnitude += std::abs(basis.weight[s]);
  }
  if (magnitude < kSingular || std::abs(total) < magnitude * (1.0 - 1e-15)) {
    return false;
  }
  double optimum = 0.0;
  basis.sum = {};
  for (int s = 0; s < basis.count; ++s) {
    basis.weight[s] = std::max(0.0, basis.weight[s] / total);
    optimum += basis.weight[s] * lp.value[basis.member[s]];
    basis.sum += basis.weight[s] * g[s];
  }
  for (int k = 0; k < basis.count - 1; ++k) {
    basis.sum[basis.axis[k]] = 0.0;
  }
  for (int axis = 0; axis < 3; ++axis) {
    optimum += lp.half[axis] * std::abs(basis.sum[axis]);
  }
  basis.optimum = optimum;
  return true;
}

// The primal step of a basis: on its axes the members are brought to one value, on the
// others it goes to the end.  Cramer's rule on the differences from the first member.
Vec3 step_of(const LinearMaxMin& lp, const Basis& basis) {
  Vec3 step;
  for (int axis = 0; axis < 3; ++axis) {
    const double slope = basis.sum[axis];
    step[axis] = slope == 0.0 ? 0.0 : std::copysign(lp.half[axis], slope);
  }
  const int n = basis.count - 1;
  std::array<Vec3, 3> column = {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0},
                                Vec3{0.0, 0.0, 1.0}};
  Vec3 difference;
  const int base = basis.member[0];
  for (int row = 0; row < n; ++row) {
    const int s = basis.member[row + 1];
    const Vec3 slope = lp.gradient[s] - lp.gradient[base];
    for (int col = 0; col < n; ++col) {
      column[col][row] = slope[basis.axis[col]];
    }
    difference[row] = lp.value[base] - lp.value[s] - dot(slope, step);
  }
  const double determinant = dot(column[0], cross(column[1], column[2]));
  for (int col = 0; col < n && determinant != 0.0; ++col) {
    std::array<Vec3, 3> replaced = column;
    replaced[col] = difference;
    const double x = dot(replaced[0], cross(replaced[1], replaced[2])) / determinant;
    const double half = lp.half[basis.axis[col]];
    step[basis.axis[col]] = std::clamp(x, -half, half);
  }
  return step;
}

// What the step of a basis attains with the surfaces up to `last`.
double attained(const LinearMaxMin& lp, const Basis& basis, int last) {
  const Vec3 step = step_of(lp, basis);
  double least = kInfinite;
  for (int s = 0; s <= last; ++s) {
    least = std::min(least, lp.value[s] + dot(lp.gradient[s], step));
  }
  return least;
}

// Whether a basis has a smaller optimum.  Several bases may share the optimum, as in the
// middle of a square, while the step of only some of them attains it: then that decides.
bool is_better(const LinearMaxMin& lp, const Basis& basis, const Basis& best, int last) {
  if (best.count == 0) {
    return true;
  }
  const double tie = 1e-12 * norm(lp.half) + 1e-15 * std::abs(best.optimum);
  if (std::abs(basis.optimum - best.optimum) > tie) {
    return basis.optimum < best.optimum;
  }
  return attained(lp, basis, last) > attained(lp, best, last);
}

// Tries every set of axes of positive width for the members of a basis.
void try_axes(const LinearMaxMin& lp, Basis& basis, Basis& best, int last) {
  constexpr std::array<std::array<std::array<int, 3>, 3>, 4> kAxes = {{
      {{{0, 0, 0}}},
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
      {{{0, 1, 0}, {1, 2, 0}, {0, 2, 0}}},
      {{{0, 1, 2}}},
  }};
  constexpr std::array<int, 4> kSets = {1, 3, 3, 1};
  for (int set = 0; set < kSets[basis.count - 1]; ++set) {
    basis.axis = kAxes[basis.count - 1][set];
    bool wide = true;
    for (int k = 0; k < basis.count - 1; ++k) {
      wide = wide && lp.half[basis.axis[k]] > 0.0;
    }
    if (wide && weigh(lp, basis) && is_better(lp, basis, best, last)) {
      best = basis;
    }
  }
}

// The best basis that contains surface `last` and surfaces before it.
Basis best_with(const LinearMaxMin& lp, int last) {
  Basis best;
  Basis basis;
  const auto try_members = [&](int count) {
    basis.count = count;
    try_axes(lp, basis, best, last);
  };
  basis.member[0] = last;
  try_members(1);
  for (int i = 0; i < last; ++i) {
    basis.member[1] = i;
    try_members(2);
    for (int j = i + 1; j < last; ++j) {
      basis.member[2] = j;
      try_members(3);
      for (int k = j + 1; k < last; ++k) {
        basis.member[3] = k;
        try_members(4);
      }
    }
  }
  return best;
}

// The linear programme at a point: the surfaces that may matter within `half`.
LinearMaxMin linearise(const std::vector<Surface>& surfaces, const int* some, int count,
                       const Vec3& point, const Vec3& half,
                       std::array<int, LinearMaxMin::kMost>& chosen) {
  LinearMaxMin lp;
  lp.half = half;
  const double range = 2.0 * norm(half);
  for (int i = 0; i < count; ++i) {
    const double value = distance(surfaces[some[i]], point);
    if (lp.count == LinearMaxMin::kMost && value >= lp.value[lp.count - 1]) {
      continue;
    }
    int at = lp.count < LinearMaxMin::kMost ? lp.count++ : lp.count - 1;
    for (; at > 0 && lp.value[at - 1] > value; --at) {
      lp.value[at] = lp.value[at - 1];
      chosen[at] = chosen[at - 1];
    }
    lp.value[at] = value;
    chosen[at] = some[i];
  }
  while (lp.count > 1 && lp.value[lp.count - 1] > lp.value[0] + range) {
    --lp.count;
  }
  for (int i = 0; i < lp.count; ++i) {
    lp.gradient[i] = direction(surfaces[chosen[i]], point);
  }
  return lp;
}

}  // namespace

LinearMaxMin::Solution LinearMaxMin::solve() const {
  Solution solution;
  Basis best = best_with(*this, 0);
  solution.step = step_of(*this, best);
  for (int s = 1; s < count; ++s) {
    if (value[s] + dot(gradient[s], solution.step) >= best.optimum) {
      continue;
    }
    const Basis better = best_with(*this, s);
    if (is_better(*this, better, best, s)) {
      best = better;
      solution.step = step_of(*this, best);
    }
  }
  solution.optimum = best.optimum;
  for (int i = 0; i < best.count; ++i) {
    solution.weight[best.member[i]] = best.weight[i];
  }
  return solution;
}

double upper_clearance(const std::vector<Surface>& surfaces, const int* some, int count,
                       const Extent& extent) {
  std::array<int, LinearMaxMin::kMost> chosen = {};
  const Vec3 half = 0.5 * (extent.hi - extent.lo);
  const LinearMaxMin lp = linearise(surfaces, some, count, extent.center(), half, chosen);
  if (lp.count == 0) {
    return kInfinite;
  }
  const LinearMaxMin::Solution solution = lp.solve();
  double bound = -kInfinite;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point{(corner & 1) != 0 ? extent.hi.x : extent.lo.x,
                     (corner & 2) != 0 ? extent.hi.y : extent.lo.y,
                     (corner & 4) != 0 ? extent.hi.z : extent.lo.z};
    double sum = 0.0;
    for (int i = 0; i < lp.count; ++i) {
      if (solution.weight[i] > 0.0) {
        sum += solution.weight[i] * distance(surfaces[chosen[i]], point);
      }
    }
    bound = std::max(bound, sum);
  }
  return bound;
}

Summit climb(const std::vector<Surface>& surfaces, const int* some, int count,
             const Extent& extent) {
  constexpr int kSteps = 8;
  const auto clearance_at = [&](const Vec3& point) {
    double least = kInfinite;
    for (int i = 0; i < count; ++i) {
      least = std::min(least, distance(surfaces[some[i]], point));
    }
    return least;
  };
  Summit summit{extent.center(), 0.0};
  summit.clearance = clearance_at(summit.point);
  std::array<int, LinearMaxMin::kMost> chosen = {};
  for (int step = 0; step < kSteps && count > 0; ++step) {
    // Linearised at the summit, stated at the centre: there the extent is a symmetric
    // box.
    const Vec3 center = extent.center();
    LinearMaxMin lp =
        linearise(surfaces, some, count, summit.point, extent.hi - extent.lo, chosen);
    lp.half = 0.5 * (extent.hi - extent.lo);
    for (int i = 0; i < lp.count; ++i) {
      lp.value[i] += dot(lp.gradient[i], center - summit.point);
    }
    const LinearMaxMin::Solution solution = lp.solve();
    Vec3 next = center + solution.step;
    for (int axis = 0; axis < 3; ++axis) {
      next[axis] = std::clamp(next[axis], extent.lo[axis], extent.hi[axis]);
    }
    const double value = clearance_at(next);
    const double gain = value - summit.clearance;
    if (!(gain > 0.0)) {
      break;
    }
    summit = {next, value};
    if (gain < 1e-13 * std::abs(value)) {
      break;
    }
  }
  return summit;
}

}  // namespace colloid
