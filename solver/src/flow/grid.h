// One level of the staggered (marker-and-cell) grid: where cells and faces are, and how
// the arrays of one level are laid out.
//
// Harlow & Welch (1965): pressure at cell centres, each velocity component on the faces
// normal to it.  Face i of an axis is the lower face of cell i.  Every array of a level
// has the same layout, with one layer of halo at the lower side and room for face n at
// the upper one, so one index serves all four unknowns:
//
//     index(i, j, k),   -1 <= i <= nx,  -1 <= j <= ny,  -1 <= k <= nz,   x fastest.
//
// Rows are padded to whole vectors of the machine, so that the kernels have no loop for
// the rest; what lies in the padding is zero, or a halo that is filled again before it is
// read.
//
// The finest level is uniform along each axis.  A coarse level joins cells in pairs; an
// odd number leaves one narrow cell at the upper end, so widths are kept per cell.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/box.h"

namespace colloid {

/// Unknowns of a level, in the order of every array of four.
enum Component : int { u_x, u_y, u_z, pressure };

/// Entries of a row are processed in blocks of this many: 64 bytes of floats.
constexpr int kBlock = 16;
constexpr int whole_blocks(int count) {
  return (count + kBlock - 1) / kBlock * kBlock;
}

struct Grid {
  std::array<int, 3> cells{};                   ///< number of cells per axis
  std::array<std::vector<double>, 3> width;     ///< cell widths per axis, grid units
  std::array<std::vector<double>, 3> position;  ///< face positions per axis, n + 1 values
  std::array<bool, 3> periodic{};

  std::ptrdiff_t stride_y = 0;
  std::ptrdiff_t stride_z = 0;
  std::size_t size = 0;    ///< entries of one array
  std::size_t origin = 0;  ///< index(0, 0, 0)

  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(origin) + i +
                                    j * stride_y + k * stride_z);
  }
  std::ptrdiff_t stride(int axis) const {
    return axis == 0 ? 1 : (axis == 1 ? stride_y : stride_z);
  }
  /// The indices of an entry, halos included: index(place) backwards.
  std::array<int, 3> place(std::size_t entry) const;
  /// The same place within one period.
  std::array<int, 3> wrapped(std::array<int, 3> at) const {
    for (std::size_t a = 0; a < 3; ++a) {
      at[a] = periodic[a] ? (at[a] + cells[a]) % cells[a] : at[a];
    }
    return at;
  }
  /// Is there an unknown of `component` at these indices?
  bool contains(int component, const std::array<int, 3>& at) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (at[a] < 0 || at[a] >= end(component, static_cast<int>(a))) {
        return false;
      }
    }
    return true;
  }
  std::size_t cell_count() const {
    return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) *
           static_cast<std::size_t>(cells[2]);
  }
  /// One past the last index along `axis` of the unknowns of `component`: a face
  /// component has n + 1 faces along its own axis unless that axis is periodic.
  int end(int component, int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    return cells[a] + (component == axis && !periodic[a] ? 1 : 0);
  }
  double centre(int axis, int i) const {
    const auto a = static_cast<std::size_t>(axis);
    const auto n = static_cast<std::size_t>(i);
    return 0.5 * (position[a][n] + position[a][n + 1]);
  }
  /// Where the unknown (component, i, j, k) lives, grid units.
  Vec3 location(int component, int i, int j, int k) const;
};

/// The uniform finest grid of a box of `extent` (grid units).
Grid make_grid(const Vec3& extent, const std::array<int, 3>& cells,
               const std::array<bool, 3>& periodic);

/// Joins cells in pairs along each axis with `along[axis]`, which has two cells at least.
Grid coarsen(const Grid& fine, const std::array<bool, 3>& along);

}  // namespace colloid
