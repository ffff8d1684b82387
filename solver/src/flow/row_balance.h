// The regular momentum balance of one velocity unknown's control volume, as a linear
// form.
//
//     F = V f - A (p above - p below) + mu sum over links of A (u_nb - u)/D     MODEL
//     (F16)
//
// Zero away from surfaces; what it leaves near one is the force on that surface.
#pragma once

#include "flow/grid.h"
#include "flow/wall_rows.h"

namespace colloid {

class RowBalance {
 public:
  explicit RowBalance(const WallRows& rows) : rows_(rows), grid_(rows.grid()) {}

  /// V, the control volume; grid units.
  double volume(int component, const std::array<int, 3>& at) const;

  /// Calls velocity(entry, weight) and push(entry, weight) with what multiplies the
  /// values of the component and of the pressure.  A link to a given velocity on a face
  /// of the box is not part of it: on_wall(face, entry, weight) gets what it takes, with
  /// its sign.
  template <class OnVelocity, class OnPressure, class OnWall>
  void visit(int component, const std::array<int, 3>& at, const OnVelocity& velocity,
             const OnPressure& push, const OnWall& on_wall) const {
    const std::size_t q = grid_.index(at[0], at[1], at[2]);
    const double all = volume(component, at);
    const double area = all / dual_length(component, component, at);
    const auto below = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(q) -
                                                grid_.stride(component));
    // On the box itself a wall feels the pressure inside alone.
    const bool given = rows_.on_given_face(component, at);
    if (!(given && at_box_face(component, at, 1))) {
      push(q, -area);
    }
    if (!(given && at_box_face(component, at, 0))) {
      push(below, area);
    }
    for (int a = 0; a < 3; ++a) {
      const SecondDifference& d = difference(component, a, at);
      const double side_area = all / dual_length(component, a, at);
      for (int side = 0; side < 2; ++side) {
        const double distance = side == 0 ? d.below : d.above;
        const Side kind = side == 0 ? d.side_below : d.side_above;
        const bool own_wall = a == component && at_box_face(component, at, side);
        if (kind == Side::no_shear || own_wall) {
          continue;
        }
        const auto there = static_cast<std::size_t>(
            static_cast<std::ptrdiff_t>(q) + (side == 0 ? -1 : 1) * grid_.stride(a));
        const double weight = side_area / distance;
        if (kind == Side::given_velocity) {
          on_wall(2 * a + side, there, -weight);
          on_wall(2 * a + side, q, weight);
        } else {
          velocity(there, weight);
          velocity(q, -weight);
        }
      }
    }
  }

 private:
  bool at_box_face(int component, const std::array<int, 3>& at, int side) const {
    const auto c = static_cast<std::size_t>(component);
    return !grid_.periodic[c] && at[c] == (side == 0 ? 0 : grid_.cells[c]);
  }
  double dual_length(int component, int axis, const std::array<int, 3>& at) const;
  const SecondDifference& difference(int component, int axis,
                                     const std::array<int, 3>& at) const {
    const auto a = static_cast<std::size_t>(axis);
    const AxisStencil& s = rows_.axes()[a];
    return (component == axis ? s.at_face : s.at_centre)[static_cast<std::size_t>(at[a])];
  }

  const WallRows& rows_;
  const Grid& grid_;
};

/// Cells next to `cell` that are open: their mean pressure stands in for a closed one's.
std::vector<std::size_t> open_neighbours(const WallRows& rows,
                                         const std::array<int, 3>& cell);

}  // namespace colloid
