// The octree grid as a mesh of OpenFOAM: no case on disk, no environment.
#pragma once

#include <memory>

#include "tiers/transient/foam.h"
#include "tiers/transient/octree.h"

namespace colloid {

/// OpenFOAM's clock and registry of everything; one at a time.
std::unique_ptr<Foam::Time> make_time();

/// A mesh whose patches are those of `octree`, in its order, and whose schemes and
/// solvers are the ones of this tier.
std::unique_ptr<Foam::fvMesh> make_foam_mesh(const Foam::Time& time,
                                             const OctreeLevels& levels,
                                             const OctreeMesh& octree);

}  // namespace colloid
