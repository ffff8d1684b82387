#include "flow/level.h"

namespace colloid {

LevelView view(const WallRows& rows) {
  const Grid& grid = rows.grid();
  const Coefficients& m = rows.coefficients();
  LevelView v;
  for (std::size_t c = 0; c < 3; ++c) {
    const AxisStencil& axis = rows.axes()[c];
    v.row_scale[c] = m.row_scale[c].data();
    v.gradient[c] = axis.gradient.data();
    v.divergence[c] = axis.divergence.data();
    v.end[c] = grid.cells[c] + (grid.periodic[c] ? 0 : 1);
    for (std::size_t a = 0; a < 3; ++a) {
      const AxisStencil& s = rows.axes()[a];
      v.link[c][a] = m.link[c][a].data();
      v.below[c][a] = (a == c ? s.face_below : s.centre_below).data();
      v.above[c][a] = (a == c ? s.face_above : s.centre_above).data();
    }
  }
  v.blocks = whole_blocks(v.end[0]) / kBlock;
  v.cell_scale = m.cell_scale.data();
  v.stride_y = grid.stride_y;
  v.stride_z = grid.stride_z;
  v.origin = grid.origin;
  v.diagonal = m.diagonal;
  return v;
}

}  // namespace colloid
