// Puts bodies back on the distances that bonds and contacts keep, after a step whose
// velocities kept them only to its order of accuracy.
#pragma once

#include <vector>

#include "particles/contact_rules.h"
#include "particles/motion.h"

namespace colloid {

/// Least displacements (over the radius, translations and turns alike) such that every
/// bond has its length and every contact in `pressed` the gap of contact.
void keep_distances(std::vector<RigidBody>& bodies, const std::vector<Contact>& pressed,
                    const FixedSurfaces& surfaces, const ContactRules& rules,
                    double radius);

}  // namespace colloid
