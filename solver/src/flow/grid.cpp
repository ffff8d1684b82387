#include "flow/grid.h"

namespace colloid {

namespace {

void lay_out(Grid& grid) {
  for (std::size_t a = 0; a < 3; ++a) {
    grid.cells[a] = static_cast<int>(grid.width[a].size());
    grid.position[a].assign(1, 0.0);
    for (double w : grid.width[a]) {
      grid.position[a].push_back(grid.position[a].back() + w);
    }
  }
  grid.stride_y = whole_blocks(grid.cells[0] + 2);
  grid.stride_z = grid.stride_y * (grid.cells[1] + 2);
  grid.origin = static_cast<std::size_t>(1 + grid.stride_y + grid.stride_z);
  // A plane and a block more than the box of indices: neighbours above the last face are
  // read, with weight zero, and rows are processed in whole blocks.
  grid.size = static_cast<std::size_t>(grid.stride_z * (grid.cells[2] + 3) +
                                       std::ptrdiff_t{2} * kBlock);
}

}  // namespace

std::array<int, 3> Grid::place(std::size_t entry) const {
  const auto split = [&](std::size_t at) {
    const auto q = static_cast<std::ptrdiff_t>(at);
    const std::ptrdiff_t k = q / stride_z;
    const std::ptrdiff_t j = (q - k * stride_z) / stride_y;
    return std::array<std::ptrdiff_t, 3>{q - k * stride_z - j * stride_y, j, k};
  };
  const auto here = split(entry);
  const auto zero = split(origin);
  return {static_cast<int>(here[0] - zero[0]), static_cast<int>(here[1] - zero[1]),
          static_cast<int>(here[2] - zero[2])};
}

Vec3 Grid::location(int component, int i, int j, int k) const {
  const std::array<int, 3> at{i, j, k};
  Vec3 x;
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    x[a] =
        component == a ? position[s][static_cast<std::size_t>(at[s])] : centre(a, at[s]);
  }
  return x;
}

Grid make_grid(const Vec3& extent, const std::array<int, 3>& cells,
               const std::array<bool, 3>& periodic) {
  Grid grid;
  grid.periodic = periodic;
  for (std::size_t a = 0; a < 3; ++a) {
    grid.width[a].assign(static_cast<std::size_t>(cells[a]),
                         extent[static_cast<int>(a)] / cells[a]);
  }
  lay_out(grid);
  return grid;
}

Grid coarsen(const Grid& fine, const std::array<bool, 3>& along) {
  Grid coarse;
  coarse.periodic = fine.periodic;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& w = fine.width[a];
    if (!along[a]) {
      coarse.width[a] = w;
      continue;
    }
    for (std::size_t i = 0; i + 1 < w.size(); i += 2) {
      coarse.width[a].push_back(w[i] + w[i + 1]);
    }
    if (w.size() % 4 == 1) {
      coarse.width[a].back() += w.back();
    } else if (w.size() % 4 == 3) {
      coarse.width[a].push_back(w.back());
    }
  }
  lay_out(coarse);
  return coarse;
}

}  // namespace colloid
