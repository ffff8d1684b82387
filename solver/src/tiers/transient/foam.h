// OpenFOAM for the few sources that use it; never included by another header of ours but
// those named foam_*.h.
#pragma once

#include "fvCFD.H"
// fvCFD.H comes first: it has no guards of its own against the names of others.
#include "OSspecific.H"
#include "core/vec3.h"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"

namespace colloid {

inline Foam::vector foam(const Vec3& v) {
  return Foam::vector(v.x, v.y, v.z);
}
inline Vec3 vec3(const Foam::vector& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace colloid
