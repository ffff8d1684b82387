// Copies of the opposite side, one layer deep, along the periodic axes.
#pragma once

#include <algorithm>

#include "flow/grid.h"

namespace colloid {

/// Halos of the other axes stay as they are: zero, the value behind a face of the box.
template <class Real>
void fill_halo(const Grid& grid, Real* x) {
  const auto [nx, ny, nz] = grid.cells;
  if (grid.periodic[0]) {
    for (int k = 0; k <= nz; ++k) {
      for (int j = 0; j <= ny; ++j) {
        x[grid.index(-1, j, k)] = x[grid.index(nx - 1, j, k)];
        x[grid.index(nx, j, k)] = x[grid.index(0, j, k)];
      }
    }
  }
  if (grid.periodic[1]) {
    for (int k = 0; k <= nz; ++k) {
      for (int i = -1; i <= nx; ++i) {
        x[grid.index(i, -1, k)] = x[grid.index(i, ny - 1, k)];
        x[grid.index(i, ny, k)] = x[grid.index(i, 0, k)];
      }
    }
  }
  if (grid.periodic[2]) {
    for (int j = -1; j <= ny; ++j) {
      for (int i = -1; i <= nx; ++i) {
        x[grid.index(i, j, -1)] = x[grid.index(i, j, nz - 1)];
        x[grid.index(i, j, nz)] = x[grid.index(i, j, 0)];
      }
    }
  }
}

/// The same for the plane k alone: its sides, and its copy beyond the far end.
template <class Real>
void fill_halo_of_plane(const Grid& grid, Real* x, int k) {
  const auto [nx, ny, nz] = grid.cells;
  if (grid.periodic[0]) {
    for (int j = 0; j <= ny; ++j) {
      x[grid.index(-1, j, k)] = x[grid.index(nx - 1, j, k)];
      x[grid.index(nx, j, k)] = x[grid.index(0, j, k)];
    }
  }
  const auto row = static_cast<std::size_t>(nx) + 2;
  if (grid.periodic[1]) {
    std::copy_n(x + grid.index(-1, ny - 1, k), row, x + grid.index(-1, -1, k));
    std::copy_n(x + grid.index(-1, 0, k), row, x + grid.index(-1, ny, k));
  }
  if (grid.periodic[2]) {
    const auto plane = static_cast<std::size_t>(grid.stride_z);
    if (k == 0) {
      std::copy_n(x + grid.index(-1, -1, 0), plane, x + grid.index(-1, -1, nz));
    }
    if (k == nz - 1) {
      std::copy_n(x + grid.index(-1, -1, k), plane, x + grid.index(-1, -1, -1));
    }
  }
}

}  // namespace colloid
