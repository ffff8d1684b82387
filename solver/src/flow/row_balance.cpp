#include "flow/row_balance.h"

namespace colloid {

double RowBalance::volume(int component, const std::array<int, 3>& at) const {
  return dual_length(component, 0, at) * dual_length(component, 1, at) *
         dual_length(component, 2, at);
}

// Half a cell on either side of a face, as far as there are cells.
double RowBalance::dual_length(int component, int axis,
                               const std::array<int, 3>& at) const {
  const auto a = static_cast<std::size_t>(axis);
  const auto& w = grid_.width[a];
  const int i = at[a];
  const int n = grid_.cells[a];
  if (component != axis) {
    return w[static_cast<std::size_t>(i)];
  }
  const bool periodic = grid_.periodic[a];
  const double below =
      i > 0 || periodic ? w[static_cast<std::size_t>((i + n - 1) % n)] : 0.0;
  const double above = i < n || periodic ? w[static_cast<std::size_t>(i % n)] : 0.0;
  return 0.5 * (below + above);
}

std::vector<std::size_t> open_neighbours(const WallRows& rows,
                                         const std::array<int, 3>& cell) {
  const Grid& grid = rows.grid();
  const auto& open = rows.coefficients().cell_scale;
  std::vector<std::size_t> found;
  for (std::size_t a = 0; a < 3; ++a) {
    for (int step : {-1, 1}) {
      std::array<int, 3> near = cell;
      near[a] += step;
      near = grid.wrapped(near);
      if (!grid.contains(pressure, near)) {
        continue;
      }
      const std::size_t n = grid.index(near[0], near[1], near[2]);
      if (open[n] > 0.0F) {
        found.push_back(n);
      }
    }
  }
  return found;
}

}  // namespace colloid
