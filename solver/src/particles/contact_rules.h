// When surfaces count as touching, and what follows.                       MODEL
// (P8)-(P10)
#pragma once

#include <limits>

#include "core/box.h"
#include "particles/surfaces.h"

namespace colloid {

/// Gaps at which surfaces touch [m]: there attraction beats drag, and below there is no
/// model of the approach.
struct ContactRules {
  double grain_gap = 0.0;    ///< colloid and grain [m]
  double colloid_gap = 0.0;  ///< two colloids [m]
  double wall_gap = 0.0;     ///< colloid and wall [m]

  bool grains_attach = true;    ///< without a push: no barrier
  bool walls_attach = false;    ///< adhesive side walls
  bool colloids_attach = true;  ///< two colloids bond when they touch
  bool aggregates = true;       ///< also if both are mobile
  // Push that makes a colloid stick where touching alone does not [N]; infinite: none.
  double grain_repulsion = std::numeric_limits<double>::infinity();
  double wall_repulsion = std::numeric_limits<double>::infinity();
};

/// Relative to the gap: where a surface counts as touching, and how well the moment of
/// contact is located.
constexpr double kContactTolerance = 1e-3;
/// Over the radius: the same where the gap is zero (inlet, symmetry).
constexpr double kLeastTolerance = 1e-7;

/// The gap of contact with a fixed surface [m]; `box` tells walls from other faces.
double contact_gap(const ContactRules& rules, const Box& box, const SurfaceId& id);

/// Half-width of the band around the gap of contact [m].
double contact_tolerance(double gap, double radius);

/// Whether touching alone makes a colloid stick there.
bool attaches(const ContactRules& rules, const Box& box, const SurfaceId& id);

/// Push [N] beyond which it sticks although touching alone is not enough; infinite if
/// none does.
double attaching_push(const ContactRules& rules, const Box& box, const SurfaceId& id);

/// Inlet and symmetry faces hold colloids back but are no surfaces.
bool is_surface(const Box& box, const SurfaceId& id);

}  // namespace colloid
