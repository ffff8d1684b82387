// Concentric square annuli over the inlet section: where retained colloids came in.
//
// A place belongs to an annulus by d = max(|x - x0|, |y - y0|), its distance from the
// section's centre in the maximum norm; annulus i holds i w <= d < (i + 1) w, and the
// last is cut off by the section's edge.  In a section that is not square an annulus is
// cut off by the nearer edges too.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "statistics/interval.h"

namespace colloid::statistics {

/// The inlet section's extent [m].
struct Section {
  Interval x;
  Interval y;
};

class Annuli {
 public:
  /// `width` w > 0 [m].
  Annuli(const Section& section, double width);

  std::size_t size() const { return edges_.size() - 1; }
  double inner(std::size_t i) const { return edges_[i]; }      ///< [m]
  double outer(std::size_t i) const { return edges_[i + 1]; }  ///< [m]
  double centre(std::size_t i) const { return 0.5 * (edges_[i] + edges_[i + 1]); }
  double area(std::size_t i) const;  ///< [m^2], of what lies inside the section

  /// The annulus of a place in the section; places outside are refused.
  std::size_t at(const std::array<double, 2>& place) const;

 private:
  double half_x_;
  double half_y_;
  double centre_x_;
  double centre_y_;
  std::vector<double> edges_;
};

}  // namespace colloid::statistics
