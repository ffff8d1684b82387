#include "observe/max_min.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace colloid {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
using Matrix = std::array<std::array<double, 5>, 4>;  // augmented by the right-hand side

// Gauss with row pivoting; false if singular to rounding.
bool solve_small(Matrix& m, int n, std::array<double, 4>& x) {
  constexpr double kSingular = 1e-13;  // gradients have length one
  for (int col = 0; col < n; ++col) {
    int best = col;
    for (int row = col + 1; row < n; ++row) {
      if (std::abs(m[row][col]) > std::abs(m[best][col])) {
        best = row;
      }
    }
    if (std::abs(m[best][col]) < kSingular) {
      return false;
    }
    std::swap(m[best], m[col]);
    for (int row = col + 1; row < n; ++row) {
      const double factor = m[row][col] / m[col][col];
      for (int k = col; k <= n; ++k) {
        m[row][k] -= factor * m[col][k];
      }
    }
  }
  for (int row = n - 1; row >= 0; --row) {
    double sum = m[row][n];
    for (int k = row + 1; k < n; ++k) {
      sum -= m[row][k] * x[k];
    }
    x[row] = sum / m[row][row];
  }
  return true;
}

struct Basis {
  int count = 0;                   // of surfaces
  std::array<int, 4> member = {};  // surfaces with weight
  std::array<int, 3> axis = {};    // count - 1 axes on which the gradients cancel
  std::array<double, 4> weight = {};
  Vec3 sum;  // of weighted gradients
  double optimum = kInfinite;
};

// The dual weights of a basis; the optimum stays infinite if they are not all positive.
void weigh(const LinearMaxMin& lp, Basis& basis) {
  Matrix m = {};
  const int n = basis.count;
  for (int col = 0; col < n; ++col) {
    for (int row = 0; row < n - 1; ++row) {
      m[row][col] = lp.gradient[basis.member[col]][basis.axis[row]];
    }
    m[n - 1][col] = 1.0;
  }
  m[n - 1][n] = 1.0;
  basis.optimum = kInfinite;
  if (!solve_small(m, n, basis.weight)) {
    return;
  }
  double optimum = 0.0;
  basis.sum = {};
  for (int i = 0; i < n; ++i) {
    if (basis.weight[i] < 0.0) {
      return;
    }
    optimum += basis.weight[i] * lp.value[basis.member[i]];
    basis.sum += basis.weight[i] * lp.gradient[basis.member[i]];
  }
  for (int row = 0; row < n - 1; ++row) {
    basis.sum[basis.axis[row]] = 0.0;
  }
  for (int axis = 0; axis < 3; ++axis) {
    optimum += lp.half[axis] * std::abs(basis.sum[axis]);
  }
  basis.optimum = optimum;
}

// The primal step of a basis: all members reach the optimum together.
Vec3 step_of(const LinearMaxMin& lp, const Basis& basis) {
  Vec3 step;
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] =
        basis.sum[axis] == 0.0 ? 0.0 : std::copysign(lp.half[axis], basis.sum[axis]);
  }
  Matrix m = {};
  const int n = basis.count;
  for (int row = 0; row < n; ++row) {
    const int s = basis.member[row];
    for (int col = 0; col < n - 1; ++col) {
      m[row][col] = lp.gradient[s][basis.axis[col]];
    }
    m[row][n - 1] = -1.0;
    m[row][n] = -lp.value[s] - dot(lp.gradient[s], step);
  }
  std::array<double, 4> x = {};
  if (n > 1 && solve_small(m, n, x)) {
    for (int col = 0; col < n - 1; ++col) {
      const double half = lp.half[basis.axis[col]];
      step[basis.axis[col]] = std::clamp(x[col], -half, half);
    }
  }
  return step;
}

// Tries every set of axes of positive width for the members of a basis.
void try_axes(const LinearMaxMin& lp, Basis& basis, Basis& best) {
  const auto keep_better = [&] {
    weigh(lp, basis);
    if (basis.optimum < best.optimum) {
      best = basis;
    }
  };
  if (basis.count == 1) {
    keep_better();
    return;
  }
  std::array<int, 3> wide = {};
  int n = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (lp.half[axis] > 0.0) {
      wide[n++] = axis;
    }
  }
  if (basis.count == 2) {
    for (int i = 0; i < n; ++i) {
      basis.axis = {wide[i], 0, 0};
      keep_better();
    }
  } else if (basis.count == 3) {
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        basis.axis = {wide[i], wide[j], 0};
        keep_better();
      }
    }
  } else if (n == 3) {
    basis.axis = {0, 1, 2};
    keep_better();
  }
}

// The best basis that contains surface `last` and surfaces before it.
Basis best_with(const LinearMaxMin& lp, int last) {
  Basis best;
  Basis basis;
  basis.member[0] = last;
  basis.count = 1;
  try_axes(lp, basis, best);
  for (int i = 0; i < last; ++i) {
    basis.member[1] = i;
    basis.count = 2;
    try_axes(lp, basis, best);
    for (int j = i + 1; j < last; ++j) {
      basis.member[2] = j;
      basis.count = 3;
      try_axes(lp, basis, best);
      for (int k = j + 1; k < last; ++k) {
        basis.member[3] = k;
        basis.count = 4;
        try_axes(lp, basis, best);
      }
    }
  }
  return best;
}

// The linear programme at a point: the surfaces that may matter within `half`.
LinearMaxMin linearise(const std::vector<Surface>& surfaces, const int* some, int count,
                       const Vec3& point, const Vec3& half, std::array<int, 8>& chosen) {
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
    if (better.optimum < best.optimum) {
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
  constexpr int kSteps = 12;
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
    // The step must end inside the extent: the largest box around the point that does not
    // leave it would shrink to nothing at a face, so the programme is set up at the
    // centre.
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
