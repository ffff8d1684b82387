// Scenes of the tests: the reference throat with deposits, and random clusters.
#pragma once

#include <random>
#include <vector>

#include "core/box.h"

namespace colloid {

struct Packing {
  Box box;
  std::vector<Sphere> spheres;
};

constexpr double kCollector = 96.6e-6;  ///< diameter [m]
constexpr double kColloid = 13.3e-6;    ///< diameter [m]

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937_64& random);

/// A box with one condition on all faces across z, inlet above and outlet below.
Box flow_box(const Vec3& size, FaceCondition sides);
Box periodic_box(const Vec3& size);

/// Four collectors on the vertical edges of a box of four walls, touching each other.
Packing empty_throat();
/// The throat with colloids of the given diameter [m] that fall straight down from random
/// places until they touch a collector, a colloid (0: none falls through for ever: at
/// most 100 tries each) and stay there: touching to rounding.
Packing clogging_throat(int colloids, std::uint64_t seed, double diameter = kColloid);

/// Spheres of random radii and places, also outside the box; some are moved to touch an
/// earlier one, some to touch a face, the rest overlap as they come.
std::vector<Sphere> random_cluster(const Vec3& size, int count, std::uint64_t seed);

/// The same packing with coordinates renamed: x to y, y to z, z to x.
Packing permuted(const Packing& packing);

}  // namespace colloid
