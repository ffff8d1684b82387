// Which cells the grid connects, and throats narrower than the grid.
//
// Touching spheres on a coarse grid can close every face of a throat that is open in
// truth. Such a throat must not end a run: where the inlet is cut off from the outlet,
// the closed faces with the largest clearance (the radius of the largest circle on the
// face that no surface touches) are opened, each as a duct of that size, until both are
// joined; the widest path is taken, as in the definition of the critical diameter. MODEL
// (F15)
#pragma once

#include <vector>

#include "flow/wall_rows.h"

namespace colloid {

/// Mean velocity through a face of area A over gradient, times A / rho^4, for a duct of
/// inscribed radius rho: a square duct (White 1991, Viscous Fluid Flow, eq 3-48).  Circle
/// 0.393, equilateral triangle 0.779.  Measured on packs (results/evidence/extremes):
/// good to a factor of 2 to 4.
constexpr double kDuctConductance = 0.5623;

/// Cells joined through open faces share a label; cells without an open face have their
/// own.
class Connectivity {
 public:
  /// `across` tells whether faces on the seam of a periodic axis join cells too.
  Connectivity(const WallRows& rows, bool across);

  std::size_t label(std::size_t cell);
  void join(std::size_t a, std::size_t b);
  /// Is a cell of one list joined to one of the other?
  bool joined(const std::vector<std::size_t>& from, const std::vector<std::size_t>& to);

 private:
  std::vector<std::size_t> parent_;
};

/// Can one go around the period of `axis` through open faces?
bool winds_around(const WallRows& rows, int axis);

/// Opens every closed face with a clearance that joins separate regions of the grid, or
/// lies on the seam of a periodic axis.  Returns how many.
int open_subgrid_throats(WallRows& rows, const std::vector<Sphere>& spheres);

}  // namespace colloid
