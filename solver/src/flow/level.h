// Everything the kernels need of one grid level, and vectors of unknowns on it.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "flow/halo.h"
#include "flow/wall_rows.h"

namespace colloid {

/// One value per unknown: three face velocities and a pressure, arrays as laid out by
/// Grid.
template <class Real>
struct StokesVector {
  std::array<std::vector<Real>, 4> a;

  StokesVector() = default;
  explicit StokesVector(std::size_t size) {
    for (auto& x : a) {
      x.assign(size, Real(0));
    }
  }
  Real* operator[](int component) {
    return a[static_cast<std::size_t>(component)].data();
  }
  const Real* operator[](int component) const {
    return a[static_cast<std::size_t>(component)].data();
  }
};

/// Kernel-side view of a level: raw pointers, strides and one-dimensional weights.
/// Weight arrays start at index -1, so weight[i + 1] belongs to index i.
struct LevelView {
  std::array<std::array<const float*, 3>, 3> link{};
  std::array<const float*, 3> row_scale{};
  const float* cell_scale = nullptr;
  std::array<std::array<const float*, 3>, 3> below{};  ///< [component][axis]
  std::array<std::array<const float*, 3>, 3> above{};
  std::array<const float*, 3> gradient{};
  std::array<const float*, 3> divergence{};
  std::array<int, 3> end{};  ///< one past the last index of any unknown
  int blocks = 0;            ///< of kBlock entries, in a row
  std::ptrdiff_t stride_y = 0;
  std::ptrdiff_t stride_z = 0;
  std::size_t origin = 0;
  double diagonal = 0.0;

  /// Where the row (j, k) begins: index(0, j, k).
  std::size_t row(int j, int k) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(origin) + j * stride_y +
                                    k * stride_z);
  }
};

/// Halos of all four unknowns.
template <class Real>
void fill_halos(const Grid& grid, StokesVector<Real>& x) {
  for (int c = 0; c < 4; ++c) {
    fill_halo(grid, x[c]);
  }
}

/// Makes x zero where an unknown was closed.
template <class Real>
void clear_entries(const std::vector<Entry>& closed, StokesVector<Real>& x) {
  for (const Entry& e : closed) {
    x.a[e.component][e.at] = Real(0);
  }
}

LevelView view(const WallRows& rows);

}  // namespace colloid
