#include "tiers/transient/octree.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"

namespace colloid {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// One cell of the octree: its base cell, and where its lower corner is on the lattice of
// the finest level.
struct Leaf {
  int base = 0;
  Index3 low{};
  int width = 1;  // on that lattice
  int level = 0;
};

// The neighbour of a base cell index along an axis; -1 outside, wrapped if periodic.
int shifted(int i, int step, int count, bool periodic) {
  const int j = i + step;
  if (j >= 0 && j < count) {
    return j;
  }
  return periodic ? (j + count) % count : -1;
}

class MeshBuilder {
 public:
  MeshBuilder(const OctreeLevels& levels, const std::vector<int>& rank_of, int rank)
      : levels_(levels), rank_of_(rank_of), rank_(rank), first_(first_cells(levels)) {
    finest_ =
        std::max<int>(0, *std::max_element(levels.level.begin(), levels.level.end()));
    for (int axis = 0; axis < 3; ++axis) {
      lattice_[at(axis)] = levels.cells[at(axis)] << finest_;
    }
  }

  OctreeMesh build() {
    list_leaves();
    for (std::size_t cell = 0; cell < leaves_.size(); ++cell) {
      for (int face = 0; face < kFaces; ++face) {
        collect(static_cast<int>(cell), face);
      }
      close_owner(static_cast<int>(cell));
    }
    close_patches();
    return std::move(mesh_);
  }

 private:
  // A face: lower corner and width on the finest lattice, normal along an axis.
  struct Square {
    Index3 low{};
    int width = 1;
    int axis = 0;
    bool outward = true;  // along the axis, seen from the owner
  };
  struct Internal {
    int neighbour = 0;
    Square square;
  };
  struct Boundary {
    Square square;
    int cell = 0;
    std::int64_t low_side = 0;   // global cells on either side, for one order on both
    std::int64_t high_side = 0;  // ranks
  };

  void list_leaves() {
    for (std::size_t base = 0; base < levels_.level.size(); ++base) {
      mesh_.first.push_back(static_cast<int>(leaves_.size()));
      const int level = levels_.level[base];
      if (level < 0 || rank_of_[base] != rank_) {
        continue;
      }
      const Index3 b = levels_.position(base);
      const int n = 1 << level;
      const int width = 1 << (finest_ - level);
      for (int child = 0; child < n * n * n; ++child) {
        Leaf leaf;
        leaf.base = static_cast<int>(base);
        leaf.level = level;
        leaf.width = width;
        const Index3 c{child % n, child / n % n, child / (n * n)};
        Vec3 centre;
        for (int axis = 0; axis < 3; ++axis) {
          leaf.low[at(axis)] = (b[at(axis)] << finest_) + c[at(axis)] * width;
          centre[axis] = (leaf.low[at(axis)] + 0.5 * width) * step(axis);
        }
        leaves_.push_back(leaf);
        mesh_.centres.push_back(centre);
        mesh_.size.push_back(width * step(0));
        mesh_.global.push_back(first_[base] + child);
      }
    }
    mesh_.first.push_back(static_cast<int>(leaves_.size()));
  }

  double step(int axis) const { return levels_.spacing(axis) / (1 << finest_); }

  // Global number of the leaf of base cell `base` that holds the lattice cube `cube`.
  std::int64_t leaf_of(std::size_t base, const Index3& cube) const {
    const int level = levels_.level[base];
    const int n = 1 << level;
    const Index3 b = levels_.position(base);
    Index3 c{};
    for (int axis = 0; axis < 3; ++axis) {
      c[at(axis)] = (cube[at(axis)] - (b[at(axis)] << finest_)) >> (finest_ - level);
    }
    return first_[base] + (static_cast<std::int64_t>(c[2]) * n + c[1]) * n + c[0];
  }

  // The faces of one side of a cell.
  void collect(int cell, int face) {
    const Leaf& leaf = leaves_[at(cell)];
    const int axis = axis_of(face);
    const bool upper = is_upper(face);
    Square square;
    square.low = leaf.low;
    square.low[at(axis)] += upper ? leaf.width : 0;
    square.width = leaf.width;
    square.axis = axis;
    square.outward = upper;
    // The lattice cube beyond the lower corner of this side.
    Index3 beyond = leaf.low;
    beyond[at(axis)] += upper ? leaf.width : -1;
    const bool outside = beyond[at(axis)] < 0 || beyond[at(axis)] >= lattice_[at(axis)];
    if (outside) {
      // Periodic pairs are coupled patch by patch; faces are split as finely as the finer
      // side.
      if (!levels_.box.periodic(axis)) {
        add_boundary(box_faces_[at(face)], square, cell);
        return;
      }
      beyond[at(axis)] = upper ? 0 : lattice_[at(axis)] - 1;
    }
    const std::size_t base = base_of(beyond);
    if (levels_.level[base] < 0) {
      add_boundary(solid_, square, cell);
      return;
    }
    const int other_width = 1 << (finest_ - levels_.level[base]);
    const int width = std::min(leaf.width, other_width);
    for (int v = 0; v < leaf.width; v += width) {
      for (int u = 0; u < leaf.width; u += width) {
        Square part = square;
        Index3 cube = beyond;
        const std::size_t a = at((axis + 1) % 3);
        const std::size_t b = at((axis + 2) % 3);
        part.low[a] += u;
        part.low[b] += v;
        cube[a] += u;
        cube[b] += v;
        part.width = width;
        add_between(cell, face, outside, base, cube, part);
      }
    }
  }

  void add_between(int cell, int face, bool outside, std::size_t base, const Index3& cube,
                   const Square& square) {
    const std::int64_t other = leaf_of(base, cube);
    const std::int64_t self = mesh_.global[at(cell)];
    if (outside) {
      add_boundary(box_faces_[at(face)], square, cell);
    } else if (rank_of_[base] == rank_) {
      const int neighbour = mesh_.first[base] + static_cast<int>(other - first_[base]);
      if (neighbour > cell) {
        internal_.push_back({neighbour, square});
      }
    } else {
      Boundary shared{square, cell, std::min(self, other), std::max(self, other)};
      ranks_[rank_of_[base]].push_back(shared);
    }
  }

  static void add_boundary(std::vector<Boundary>& list, const Square& square, int cell) {
    list.push_back({square, cell, 0, 0});
  }

  std::size_t base_of(const Index3& cube) const {
    return levels_.index(cube[0] >> finest_, cube[1] >> finest_, cube[2] >> finest_);
  }

  int point(const Index3& p) {
    const std::int64_t key =
        (static_cast<std::int64_t>(p[2]) * (lattice_[1] + 1) + p[1]) * (lattice_[0] + 1) +
        p[0];
    if (points_.empty()) {
      points_.assign(static_cast<std::size_t>(lattice_[0] + 1) *
                         static_cast<std::size_t>(lattice_[1] + 1) *
                         static_cast<std::size_t>(lattice_[2] + 1),
                     -1);
    }
    int& number = points_[static_cast<std::size_t>(key)];
    if (number < 0) {
      number = static_cast<int>(mesh_.points.size());
      mesh_.points.push_back({p[0] * step(0), p[1] * step(1), p[2] * step(2)});
    }
    return number;
  }

  void add_face(const Square& square, int owner) {
    const std::size_t a = at((square.axis + 1) % 3);
    const std::size_t b = at((square.axis + 2) % 3);
    std::array<Index3, 4> corners{square.low, square.low, square.low, square.low};
    corners[1][a] += square.width;
    corners[2][a] += square.width;
    corners[2][b] += square.width;
    corners[3][b] += square.width;
    std::array<int, 4> face{};
    for (int c = 0; c < 4; ++c) {
      // Reversed, the first corner stays the first.
      face[at(c)] = point(corners[at(square.outward ? c : (4 - c) % 4)]);
    }
    mesh_.faces.push_back(face);
    mesh_.owner.push_back(owner);
  }

  // Upper-triangular order: the faces of an owner by neighbour.
  void close_owner(int cell) {
    std::sort(internal_.begin(), internal_.end(),
              [](const Internal& x, const Internal& y) {
                return x.neighbour != y.neighbour ? x.neighbour < y.neighbour
                                                  : x.square.low < y.square.low;
              });
    for (const Internal& face : internal_) {
      add_face(face.square, cell);
      mesh_.neighbour.push_back(face.neighbour);
    }
    internal_.clear();
  }

  void close(FacePatch::Kind kind, int which, std::vector<Boundary>& list) {
    // By place: the order is then the same on both sides of a periodic pair.
    std::sort(list.begin(), list.end(), [&](const Boundary& x, const Boundary& y) {
      if (kind == FacePatch::Kind::rank) {
        if (x.low_side != y.low_side) {
          return x.low_side < y.low_side;
        }
        if (x.high_side != y.high_side) {
          return x.high_side < y.high_side;
        }
      }
      const Index3& p = x.square.low;
      const Index3& q = y.square.low;
      return std::array{p[2], p[1], p[0]} < std::array{q[2], q[1], q[0]};
    });
    FacePatch patch{kind, which, static_cast<int>(mesh_.faces.size()),
                    static_cast<int>(list.size())};
    for (const Boundary& face : list) {
      add_face(face.square, face.cell);
    }
    mesh_.patches.push_back(patch);
  }

  void close_patches() {
    for (int face = 0; face < kFaces; ++face) {
      close(FacePatch::Kind::box_face, face, box_faces_[at(face)]);
    }
    close(FacePatch::Kind::solid, 0, solid_);
    for (auto& [other, list] : ranks_) {
      close(FacePatch::Kind::rank, other, list);
    }
  }

  const OctreeLevels& levels_;
  const std::vector<int>& rank_of_;
  int rank_;
  int finest_ = 0;
  Index3 lattice_{};  // cubes of the finest level along each axis
  std::vector<std::int64_t> first_;
  std::vector<Leaf> leaves_;
  std::vector<int> points_;  // number of each lattice point; -1: not used
  std::vector<Internal> internal_;
  std::array<std::vector<Boundary>, kFaces> box_faces_;
  std::vector<Boundary> solid_;
  std::map<int, std::vector<Boundary>> ranks_;
  OctreeMesh mesh_;
};

// Largest level around a base cell.
int highest_neighbour(const OctreeLevels& levels, int i, int j, int k) {
  int highest = 0;
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const int x = shifted(i, di, levels.cells[0], levels.box.periodic(0));
        const int y = shifted(j, dj, levels.cells[1], levels.box.periodic(1));
        const int z = shifted(k, dk, levels.cells[2], levels.box.periodic(2));
        if (x >= 0 && y >= 0 && z >= 0) {
          highest = std::max<int>(highest, levels.level[levels.index(x, y, z)]);
        }
      }
    }
  }
  return highest;
}

int axis_to_cut(const OctreeLevels& levels) {
  int axis = -1;
  for (int candidate = 0; candidate < 3; ++candidate) {
    if (!levels.box.periodic(candidate) &&
        (axis < 0 || levels.cells[at(candidate)] > levels.cells[at(axis)])) {
      axis = candidate;
    }
  }
  return axis;
}

}  // namespace

void balance(OctreeLevels& levels) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int k = 0; k < levels.cells[2]; ++k) {
      for (int j = 0; j < levels.cells[1]; ++j) {
        for (int i = 0; i < levels.cells[0]; ++i) {
          int& level = levels.level[levels.index(i, j, k)];
          const int needed = highest_neighbour(levels, i, j, k) - 1;
          if (level >= 0 && level < needed) {
            level = needed;
            changed = true;
          }
        }
      }
    }
  }
}

Index3 OctreeLevels::position(std::size_t index) const {
  const auto nx = static_cast<std::size_t>(cells[0]);
  const auto ny = static_cast<std::size_t>(cells[1]);
  return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
          static_cast<int>(index / (nx * ny))};
}

Vec3 OctreeLevels::centre(std::size_t index) const {
  const Index3 place = position(index);
  Vec3 x;
  for (int axis = 0; axis < 3; ++axis) {
    x[axis] = (place[at(axis)] + 0.5) * spacing(axis);
  }
  return x;
}

std::vector<std::int64_t> first_cells(const OctreeLevels& levels) {
  std::vector<std::int64_t> first(levels.level.size() + 1, 0);
  for (std::size_t base = 0; base < levels.level.size(); ++base) {
    const int level = levels.level[base];
    first[base + 1] = first[base] + (level < 0 ? 0 : std::int64_t{1} << (3 * level));
  }
  return first;
}

std::vector<std::size_t> base_cells_around(const OctreeLevels& levels, const Vec3& x,
                                           double reach) {
  std::array<std::vector<int>, 3> along;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = levels.cells[at(axis)];
    const double h = levels.spacing(axis);
    int low = static_cast<int>(std::floor((x[axis] - reach) / h));
    int high = static_cast<int>(std::floor((x[axis] + reach) / h));
    if (!levels.box.periodic(axis) || high - low >= n) {
      low = levels.box.periodic(axis) ? 0 : std::max(low, 0);
      high = levels.box.periodic(axis) ? n - 1 : std::min(high, n - 1);
    }
    for (int i = low; i <= high; ++i) {
      along[at(axis)].push_back((i % n + n) % n);
    }
    std::sort(along[at(axis)].begin(), along[at(axis)].end());
  }
  std::vector<std::size_t> out;
  for (const int k : along[2]) {
    for (const int j : along[1]) {
      for (const int i : along[0]) {
        out.push_back(levels.index(i, j, k));
      }
    }
  }
  return out;
}

std::vector<int> cells_around(const OctreeLevels& levels, const OctreeMesh& mesh,
                              const Vec3& x, double reach) {
  std::vector<int> out;
  for (const std::size_t base : base_cells_around(levels, x, reach)) {
    for (int cell = mesh.first[base]; cell < mesh.first[base + 1]; ++cell) {
      out.push_back(cell);
    }
  }
  return out;
}

std::vector<int> partition(const OctreeLevels& levels, int ranks) {
  std::vector<int> rank_of(levels.level.size(), 0);
  if (ranks == 1) {
    return rank_of;
  }
  const int axis = axis_to_cut(levels);
  require(
      axis >= 0, "/geometry/box",
      "is periodic along all axes, which one rank alone can compute; expected 1 rank");
  bool whole_layers = false;
  for (int other = 0; other < 3; ++other) {
    whole_layers = whole_layers || levels.box.periodic(other);
  }
  const std::size_t a = at(axis);
  const std::size_t b = at((axis + 1) % 3);
  const std::size_t c = at((axis + 2) % 3);
  const std::int64_t total = first_cells(levels).back();
  std::int64_t before = 0;
  Index3 p{};
  for (p[a] = 0; p[a] < levels.cells[a]; ++p[a]) {
    const std::int64_t layer_before = before;
    for (p[b] = 0; p[b] < levels.cells[b]; ++p[b]) {
      for (p[c] = 0; p[c] < levels.cells[c]; ++p[c]) {
        const std::size_t base = levels.index(p[0], p[1], p[2]);
        const std::int64_t so_far = whole_layers ? layer_before : before;
        rank_of[base] =
            static_cast<int>(std::min<std::int64_t>(ranks - 1, so_far * ranks / total));
        before +=
            levels.level[base] < 0 ? 0 : std::int64_t{1} << (3 * levels.level[base]);
      }
    }
  }
  return rank_of;
}

OctreeMesh build_mesh(const OctreeLevels& levels, const std::vector<int>& rank_of,
                      int rank) {
  return MeshBuilder(levels, rank_of, rank).build();
}

}  // namespace colloid
