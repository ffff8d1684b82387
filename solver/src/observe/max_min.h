// The largest clearance inside a small box: a certified bound from above, a point from
// below.
#pragma once

#include <array>
#include <vector>

#include "observe/surface.h"

namespace colloid {

/// A linear programme: max over |delta_i| <= h_i of min_s (v_s + g_s . delta).
///
/// Its dual is the min over weights lambda_s >= 0, sum lambda_s = 1, of
///
///     sum_s lambda_s v_s + sum_i h_i |sum_s lambda_s g_si|
///
/// The optimum lies at a basis: up to four surfaces, with one axis fewer on which the
/// weighted gradients cancel.  Surfaces are taken in one by one and only bases with a
/// violated newcomer are tried, so that a solution costs a few dozen tiny systems.
struct LinearMaxMin {
  static constexpr int kMost = 6;
  int count = 0;
  std::array<double, kMost> value = {};   ///< v_s [m]
  std::array<Vec3, kMost> gradient = {};  ///< g_s [-]
  Vec3 half;                              ///< h [m]

  struct Solution {
    double optimum = 0.0;  ///< [m]
    std::array<double, kMost> weight = {};
    Vec3 step;  ///< the maximising delta [m]
  };
  Solution solve() const;
};

/// An upper bound of the largest clearance in an extent [m].
///
/// min_s d_s <= sum_s lambda_s d_s, which is convex: its maximum is at a corner.  With
/// the weights of the linear programme at the centre the bound exceeds the maximum by a
/// term of second order in the extent, where the largest distance to a single surface
/// would exceed it by one of first order.  `some` are the surfaces that can be nearest
/// there.
double upper_clearance(const std::vector<Surface>& surfaces, const int* some, int count,
                       const Extent& extent);

struct Summit {
  Vec3 point;              ///< in the extent
  double clearance = 0.0;  ///< at the point [m]
};
/// A point of large clearance in an extent, by repeated linear programmes from its
/// centre. Distances are convex, so they exceed their linearisations and no step can
/// lose.
Summit climb(const std::vector<Surface>& surfaces, const int* some, int count,
             const Extent& extent);

}  // namespace colloid
