// What becomes of a body that stops: its colloids are retained.          MODEL (P9),
// (P14)
#pragma once

#include <vector>

#include "io/realisation.h"
#include "particles/body_motion.h"
#include "particles/contact_rules.h"
#include "particles/motion.h"
#include "particles/surfaces.h"
#include "particles/suspension.h"

namespace colloid {

/// What judging a retention needs.
struct RetentionContext {
  const FixedSurfaces& surfaces;
  const ContactRules& rules;
  double radius = 0.0;  ///< a [m]
  Vec3 upstream;        ///< unit vector against the flow
  double grain_pull_off = 0.0, wall_pull_off = 0.0, colloid_pull_off = 0.0;  ///< [N]
};

/// The records of a body's colloids, `first` (a member) in front; order and time are the
/// caller's.  `held`: the flow's wrench on the body if held.
std::vector<RetainedColloid> describe_retention(const RetentionContext& context,
                                                const RigidBody& body, std::size_t first,
                                                const BodyWrench& held);

/// Whether grains and walls alone, without adhesion or friction, keep a sphere at `x`
/// from moving under `force`: two surfaces at least, within 1 % of the radius.
bool held_by_geometry(const RetentionContext& context, const Vec3& x, const Vec3& force);

}  // namespace colloid
