// What the scene's surface chemistry means for contacts.                  MODEL (P8),
// (P9)
#pragma once

#include <memory>
#include <optional>

#include "particles/contact_rules.h"
#include "physics/pair_analysis.h"
#include "physics/surface_pair.h"
#include "scene/scene.h"

namespace colloid {

/// The three kinds of pairs of a scene with colloids.
SurfacePair colloid_grain_pair(const Scene& scene);
SurfacePair colloid_wall_pair(const Scene& scene);
SurfacePair colloid_colloid_pair(const Scene& scene);

/// How one kind of pair meets.
struct PairContact {
  SurfaceForces forces;
  PairAnalysis analysis;
  /// Nothing keeps the surfaces apart that heat would not overcome at once.
  bool attracts = false;
  double gap = 0.0;       ///< of contact [m]
  double pull_off = 0.0;  ///< force that parts them again [N]
};

/// Thermal energies that a barrier needs to keep surfaces apart, and a minimum to hold
/// them together: below five, Brownian motion passes in milliseconds.
constexpr double kLeastBarrier = 5.0;

/// `drag`: Stokes drag on a colloid at the inlet's mean speed [N].
PairContact meet(const SurfacePair& pair, double drag);

struct SurfaceModel {
  PairContact grain;
  PairContact wall;
  PairContact colloid;
  ContactRules rules;
};

SurfaceModel make_surface_model(const Scene& scene, double drag);

}  // namespace colloid
