// The DLVO force of a pair as it acts in the sub-steps.                   MODEL (T-D4)
#pragma once

#include "tiers/surface_model.h"

namespace colloid {

/// The force of the pair's curve from `range` down to `inner`; within, that at `inner`:
/// an attracting pair is in contact there, a repelling one at the top of its repulsion.
class DemSurfaceForce {
 public:
  /// `repulsion_alone`: an inert wall does not attract.
  DemSurfaceForce(const PairContact& contact, double least_force, bool repulsion_alone);

  double at(double gap) const;  ///< [N], positive = repulsive
  double range() const { return range_; }
  double inner() const { return inner_; }
  /// Largest |dF/dh| [N/m].
  double steepest() const;

 private:
  SurfaceForces forces_;
  double range_ = 0.0;
  double inner_ = 0.0;
  bool repulsion_alone_ = false;
};

}  // namespace colloid
