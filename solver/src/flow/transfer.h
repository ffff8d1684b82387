// Residuals to the next coarser level, corrections back from it.
//
// Restriction averages fine residuals over the control volume of the coarse unknown.
// Velocity corrections are interpolated linearly along every axis, the pressure's is
// copied from the parent cell.  Weights are one-dimensional; narrow last cells and axes
// that are not coarsened are in them.
#pragma once

#include <array>
#include <vector>

#include "flow/level.h"

namespace colloid {

/// Weights between two levels along one axis, for unknowns at faces or at centres.
struct LineTransfer {
  bool coarsened = true;

  std::vector<int> near;         ///< fine index -> a coarse index
  std::vector<int> far;          ///< fine index -> the other coarse index
  std::vector<float> near_part;  ///< their weights
  std::vector<float> far_part;
  std::vector<int> first;                  ///< coarse index -> first fine index
  std::vector<std::array<float, 3>> part;  ///< weights of first, first+1, first+2

  // The same for a whole row of a coarsened axis, coarse index I; zero beyond the row.
  //   fine 2I   = even_here s[I] + even_below s[I-1]
  //   fine 2I+1 = odd_here s[I] + odd_above s[I+1]
  //   coarse I  = take[0] r[2I-1] + take[1] r[2I] + take[2] r[2I+1] + take[3] r[2I+2]
  std::vector<float> even_here, even_below, odd_here, odd_above;
  std::array<std::vector<float>, 4> take;
};

struct LevelTransfer {
  std::array<LineTransfer, 3> face;    ///< per axis
  std::array<LineTransfer, 3> centre;  ///< per axis, velocities
  std::array<LineTransfer, 3> cell;    ///< per axis, pressure
};

LevelTransfer make_transfer(const Grid& fine, const Grid& coarse,
                            const std::array<AxisStencil, 3>& fine_axes);

/// f_coarse = averages of r_fine on the coarse plane K; zero in closed rows and cells.
void restrict_plane(const LevelTransfer& t, const LevelView& fine,
                    const LevelView& coarse, const StokesVector<float>& r_fine,
                    StokesVector<float>& f_coarse, int K);

/// u_fine += interpolation of u_coarse on the fine plane k, in open rows and cells.
void prolong_plane(const LevelTransfer& t, const LevelView& fine, const LevelView& coarse,
                   const StokesVector<float>& u_coarse, StokesVector<float>& u_fine,
                   int k);

}  // namespace colloid
