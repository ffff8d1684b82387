// LIGGGHTS' arrays as its fix hands them to our forces; no type of LIGGGHTS.
#pragma once

#include <vector>

#include "core/vec3.h"

namespace colloid {

enum DemType : int { dem_mobile = 1, dem_grain = 2, dem_held = 3, dem_smooth_plane = 4 };

struct DemAtoms {
  int local = 0;  ///< atoms; ghosts follow them
  double** x = nullptr;
  double** v = nullptr;
  double** omega = nullptr;
  double** f = nullptr;
  double** torque = nullptr;
  const int* tag = nullptr;
  int* type = nullptr;
  int* mask = nullptr;
  const double* radius = nullptr;
};

inline Vec3 vector(const double* p) {
  return {p[0], p[1], p[2]};
}
inline void set(double* p, const Vec3& value) {
  p[0] = value.x;
  p[1] = value.y;
  p[2] = value.z;
}
inline void add(double* p, const Vec3& value) {
  p[0] += value.x;
  p[1] += value.y;
  p[2] += value.z;
}

/// Neighbours, each pair once.  `second` may be a ghost, then `second_local` is the atom
/// it is the image of.
struct DemPair {
  int first = -1;
  int second = -1;
  int second_local = -1;
};

}  // namespace colloid
