// The pressure around bodies, carried along with them from step to step.      MODEL (T6)
#pragma once

#include <vector>

#include "scene/scene.h"
#include "tiers/transient/foam.h"
#include "tiers/transient/octree.h"

namespace colloid {

class CarriedPressure {
 public:
  /// Moves what the pressure around each body is because of it as far as the body has
  /// gone since the last call: a first guess at what the next step finds.  A body is
  /// known again by having gone less than `cell` [m]; around others, and around those
  /// that stay, nothing moves.
  void carry(const OctreeLevels& levels, const OctreeMesh& mesh,
             const std::vector<Sphere>& bodies, double cell,
             Foam::volScalarField& pressure);

  /// Where the bodies were at the last call; for checkpoints.
  const std::vector<Sphere>& bodies() const { return last_; }
  void restore(std::vector<Sphere> bodies) { last_ = std::move(bodies); }

 private:
  std::vector<Sphere> last_;
};

}  // namespace colloid
