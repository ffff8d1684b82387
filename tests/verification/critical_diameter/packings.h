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
/// The throat with at most so many colloids of the given diameter [m]: each falls
/// straight down from a random place and stays where it first touches a collector or a
/// colloid, to rounding; those that fall through are drawn again, a hundred times the
/// count in all.
Packing clogging_throat(int colloids, std::uint64_t seed, double diameter = kColloid);

/// Spheres of random radii and places, also outside the box; some are moved to touch an
/// earlier one, some to touch a face, the rest overlap as they come.
std::vector<Sphere> random_cluster(const Vec3& size, int count, std::uint64_t seed);

/// The same packing with coordinates renamed: x to y, y to z, z to x.
Packing permuted(const Packing& packing);

}  // namespace colloid
