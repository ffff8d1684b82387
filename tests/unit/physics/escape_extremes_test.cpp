// Escape over a barrier for pairs and forces from one end of their ranges to the other.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "physics/barrier_escape.h"

namespace colloid {
namespace {

/// Uniform and log-uniform numbers that do not depend on the library.
class Draw {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) / 9007199254740992.0;
  }
  double decades(double low, double high) {
    return low * std::pow(high / low, between(0.0, 1.0));
  }
  bool chance(double p) { return between(0.0, 1.0) < p; }

 private:
  std::mt19937_64 random_{1};
};

TEST(EscapeExtremes, IsAPositiveTimeOrInfinityForEveryPairAndForce) {
  Draw draw;
  int finite = 0;
  constexpr int kPairs = 200;
  for (int i = 0; i < kPairs; ++i) {
    SurfacePair pair;
    pair.radius = draw.decades(5e-9, 1e-4);
    pair.other_radius = pair.radius * draw.decades(0.05, 100.0);
    pair.shape = draw.chance(0.8) ? PairShape::sphere_plate : PairShape::two_spheres;
    pair.zeta = draw.between(-0.08, 0.05);
    pair.other_zeta = draw.between(-0.08, 0.05);
    pair.hamaker = draw.decades(1e-22, 1e-19) * (draw.chance(0.2) ? -1.0 : 1.0);
    pair.born_diameter = draw.chance(0.3) ? 0.0 : 0.5e-9;
    pair.closest_gap = draw.decades(1e-10, 1e-9);
    pair.electrolyte.ionic_strength = draw.decades(1e-2, 3000.0);
    const SurfaceForces forces(pair);
    EscapeConditions conditions;
    conditions.viscosity = draw.decades(1e-4, 1.0);
    conditions.force_towards = draw.chance(0.1) ? 0.0 : draw.decades(1e-17, 1e-7);
    conditions.force_towards *= draw.chance(0.5) ? 1.0 : -1.0;
    const BarrierEscape found = barrier_escape(forces, analyse_pair(forces), conditions);
    EXPECT_GT(found.time, 0.0) << i;
    EXPECT_GE(found.barrier_kT, 0.0) << i;
    EXPECT_TRUE(std::isfinite(found.start_gap)) << i;
    finite += std::isfinite(found.time) ? 1 : 0;
  }
  // Neither answer is the exception.
  EXPECT_GT(finite, kPairs / 4);
  EXPECT_LT(finite, 3 * kPairs / 4);
}

}  // namespace
}  // namespace colloid
