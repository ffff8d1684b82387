#include "flow/connectivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/constants.h"

namespace colloid {

namespace {

constexpr int kScan = 12;  // points per side of a face in the first look for a clearance
constexpr int kRefinements = 40;  // halvings of the pattern search around the best point

struct ClosedFace {
  double clearance;
  int component;
  std::size_t face;
};

// Calls visit(component, face, cell below, cell above) for every face between two cells.
template <class Visit>
void for_inner_faces(const Grid& grid, const Visit& visit) {
  for (int c = 0; c < 3; ++c) {
    const auto s = static_cast<std::size_t>(c);
    for (int k = 0; k < grid.cells[2]; ++k) {
      for (int j = 0; j < grid.cells[1]; ++j) {
        for (int i = 0; i < grid.cells[0]; ++i) {
          std::array<int, 3> at{i, j, k};
          const std::size_t face = grid.index(i, j, k);
          if (at[s] == 0 && !grid.periodic[s]) {
            continue;
          }
          at[s] = (at[s] + grid.cells[s] - 1) % grid.cells[s];
          visit(c, std::array<int, 3>{i, j, k}, face, grid.index(at[0], at[1], at[2]));
        }
      }
    }
  }
}

// Distance from x to the nearest of the spheres, periodic images included.
double distance_to(const std::vector<Sphere>& spheres, const Grid& grid, const Vec3& x) {
  double nearest = 1e300;
  for (const Sphere& s : spheres) {
    Vec3 e = x - s.center;
    for (int a = 0; a < 3; ++a) {
      const auto p = static_cast<std::size_t>(a);
      if (grid.periodic[p]) {
        const double length = grid.position[p].back();
        e[a] -= length * std::round(e[a] / length);
      }
    }
    nearest = std::min(nearest, norm(e) - s.radius);
  }
  return nearest;
}

// Largest distance to the surfaces over a face: a scan and a pattern search around its
// best point. NOLINTNEXTLINE(readability-function-size)
double face_clearance(const std::vector<Sphere>& spheres, const Grid& grid, int component,
                      const std::array<int, 3>& at) {
  const int t1 = (component + 1) % 3;
  const int t2 = (component + 2) % 3;
  const Vec3 centre = grid.location(component, at[0], at[1], at[2]);
  const auto half = [&](int t) {
    const auto s = static_cast<std::size_t>(t);
    return 0.5 * grid.width[s][static_cast<std::size_t>(at[s])];
  };
  // Only surfaces that reach the face matter.
  std::vector<Sphere> near;
  const double radius = std::hypot(half(t1), half(t2));
  for (const Sphere& s : spheres) {
    if (distance_to({s}, grid, centre) < 3.0 * radius) {
      near.push_back(s);
    }
  }
  const auto value = [&](double a, double b) {
    Vec3 x = centre;
    x[t1] += a * half(t1);
    x[t2] += b * half(t2);
    return distance_to(near, grid, x);
  };
  double best = -1e300;
  double best_a = 0.0;
  double best_b = 0.0;
  for (int m = 0; m <= kScan; ++m) {
    for (int n = 0; n <= kScan; ++n) {
      const double a = 2.0 * m / kScan - 1.0;
      const double b = 2.0 * n / kScan - 1.0;
      const double v = value(a, b);
      if (v > best) {
        best = v;
        best_a = a;
        best_b = b;
      }
    }
  }
  double step = 2.0 / kScan;
  for (int round = 0; round < kRefinements; ++round) {
    bool better = false;
    for (int m = -1; m <= 1; ++m) {
      for (int n = -1; n <= 1; ++n) {
        const double a = std::clamp(best_a + m * step, -1.0, 1.0);
        const double b = std::clamp(best_b + n * step, -1.0, 1.0);
        const double v = value(a, b);
        if (v > best) {
          best = v;
          best_a = a;
          best_b = b;
          better = true;
        }
      }
    }
    if (!better) {
      step *= 0.5;
    }
  }
  return best;
}

}  // namespace

Connectivity::Connectivity(const WallRows& rows, bool across)
    : parent_(rows.grid().size) {
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  for_inner_faces(rows.grid(), [&](int c, const std::array<int, 3>& at, std::size_t face,
                                   std::size_t below) {
    const auto s = static_cast<std::size_t>(c);
    if ((across || at[s] > 0) && rows.coefficients().row_scale[s][face] > 0.0F) {
      join(face, below);
    }
  });
}

bool Connectivity::joined(const std::vector<std::size_t>& from,
                          const std::vector<std::size_t>& to) {
  std::vector<std::size_t> labels;
  labels.reserve(to.size());
  for (std::size_t cell : to) {
    labels.push_back(label(cell));
  }
  std::sort(labels.begin(), labels.end());
  return std::any_of(from.begin(), from.end(), [&](std::size_t cell) {
    return std::binary_search(labels.begin(), labels.end(), label(cell));
  });
}

std::size_t Connectivity::label(std::size_t cell) {
  while (parent_[cell] != cell) {
    parent_[cell] = parent_[parent_[cell]];
    cell = parent_[cell];
  }
  return cell;
}

void Connectivity::join(std::size_t a, std::size_t b) {
  const std::size_t ra = label(a);
  const std::size_t rb = label(b);
  parent_[std::max(ra, rb)] = std::min(ra, rb);
}

// One breadth-first search with its step inside.
// NOLINTNEXTLINE(readability-function-size)
bool winds_around(const WallRows& rows, int axis) {
  const Grid& grid = rows.grid();
  const auto seam = static_cast<std::size_t>(axis);
  // Breadth first; two ways to a cell that differ in periods make a loop around the box.
  constexpr int kUnseen = std::numeric_limits<int>::min();
  std::vector<int> periods(grid.size, kUnseen);
  std::vector<std::array<int, 3>> queue;
  bool winds = false;
  const auto visit = [&](const std::array<int, 3>& from, std::size_t a, int step) {
    std::array<int, 3> to = from;
    to[a] += step;
    // The face between both is the lower one of the upper cell.
    const std::array<int, 3> upper = step > 0 ? to : from;
    if (!grid.periodic[a] && (upper[a] == 0 || upper[a] == grid.cells[a])) {
      return;
    }
    const int n = grid.cells[a];
    std::array<int, 3> face = upper;
    face[a] = (face[a] + n) % n;
    if (rows.coefficients().row_scale[a][grid.index(face[0], face[1], face[2])] <= 0.0F) {
      return;
    }
    int there = periods[grid.index(from[0], from[1], from[2])];
    if (a == seam) {
      there += to[a] >= n ? 1 : (to[a] < 0 ? -1 : 0);
    }
    to[a] = (to[a] + n) % n;
    int& known = periods[grid.index(to[0], to[1], to[2])];
    if (known == kUnseen) {
      known = there;
      queue.push_back(to);
    } else if (known != there) {
      winds = true;
    }
  };
  for (int k = 0; k < grid.cells[2]; ++k) {
    for (int j = 0; j < grid.cells[1]; ++j) {
      for (int i = 0; i < grid.cells[0]; ++i) {
        if (periods[grid.index(i, j, k)] != kUnseen) {
          continue;
        }
        periods[grid.index(i, j, k)] = 0;
        queue.assign(1, {i, j, k});
        for (std::size_t next = 0; next < queue.size() && !winds; ++next) {
          for (std::size_t a = 0; a < 3; ++a) {
            visit(std::array<int, 3>(queue[next]), a, -1);
            visit(std::array<int, 3>(queue[next]), a, 1);
          }
        }
        if (winds) {
          return true;
        }
      }
    }
  }
  return false;
}

int open_subgrid_throats(WallRows& rows, const std::vector<Sphere>& spheres) {
  const Grid& grid = rows.grid();
  Connectivity regions(rows, false);
  std::vector<ClosedFace> faces;
  for_inner_faces(grid, [&](int c, const std::array<int, 3>& at, std::size_t face,
                            std::size_t below) {
    const auto s = static_cast<std::size_t>(c);
    const bool on_seam = at[s] == 0;
    if (rows.coefficients().row_scale[s][face] > 0.0F ||
        (!on_seam && regions.label(face) == regions.label(below)) ||
        rows.nearest(c, at[0], at[1], at[2]).distance < -grid.width[0].front()) {
      return;
    }
    const double clearance = face_clearance(spheres, grid, c, at);
    if (clearance > 0.0) {
      faces.push_back({clearance, c, face});
    }
  });
  for (const ClosedFace& f : faces) {
    const auto c = static_cast<std::size_t>(f.component);
    const double area = grid.width[(c + 1) % 3].front() * grid.width[(c + 2) % 3].front();
    rows.open_subgrid(f.component, f.face,
                      kDuctConductance * std::pow(f.clearance, 4) / area);
  }
  rows.update_cells();
  return static_cast<int>(faces.size());
}

}  // namespace colloid
