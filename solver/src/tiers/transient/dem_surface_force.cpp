#include "tiers/transient/dem_surface_force.h"

#include <algorithm>
#include <cmath>

namespace colloid {

DemSurfaceForce::DemSurfaceForce(const PairContact& contact, double least_force,
                                 bool repulsion_alone)
    : forces_(contact.forces), repulsion_alone_(repulsion_alone) {
  range_ = interaction_range(forces_, least_force);
  const ForceAtGap& repulsion = contact.analysis.largest_repulsion;
  inner_ = contact.attracts || repulsion.force <= 0.0 ? contact.gap : repulsion.gap;
}

double DemSurfaceForce::at(double gap) const {
  if (gap >= range_) {
    return 0.0;
  }
  const double force = forces_.force(std::max(gap, inner_));
  return repulsion_alone_ ? std::max(0.0, force) : force;
}

double DemSurfaceForce::steepest() const {
  constexpr int kSamples = 2000;
  double steepest = 0.0;
  if (range_ <= inner_) {
    return steepest;
  }
  const double ratio = std::pow(range_ / inner_, 1.0 / kSamples);
  double gap = inner_;
  double force = forces_.force(gap);
  for (int i = 0; i < kSamples; ++i) {
    const double next = gap * ratio;
    const double there = forces_.force(next);
    steepest = std::max(steepest, std::abs(there - force) / (next - gap));
    gap = next;
    force = there;
  }
  return steepest;
}

}  // namespace colloid
