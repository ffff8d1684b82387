// The first captures do not depend on the step: see README.md beside this file.
#include <cstdio>

#include <gtest/gtest.h>

#include "short_scene.h"

namespace colloid {
namespace {

// A step half as inaccurate changes the first captures by no more than the steps may err:
// each of a colloid's at most few hundred steps by the tolerance times its radius, in
// time that over the inlet's speed.
TEST(StepTolerance, HalfOfItLeavesTheFirstCaptures) {
  constexpr std::uint64_t kSeeds = PORECLOG_SEEDS;
  const Scene scene = short_scene();
  constexpr double kSteps = 300.0;
  const double within = kSteps * 1e-3 * 6.65e-6 / 0.5e-3;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RunOptions options;
    options.seed = seed;
    const Realisation coarse = run(scene, options);
    options.step_tolerance = 0.5e-3;
    const Realisation fine = run(scene, options);
    for (std::size_t n = 0; n < 3; ++n) {
      if (n >= coarse.retained.size() || n >= fine.retained.size()) {
        continue;
      }
      const RetainedColloid& a = coarse.retained[n];
      const RetainedColloid& b = fine.retained[n];
      std::printf("seed %lu, capture %zu: colloid %ld at %.6f s, %ld at %.6f s\n",
                  static_cast<unsigned long>(seed), n + 1, a.colloid, a.time, b.colloid,
                  b.time);
      EXPECT_EQ(a.colloid, b.colloid) << "seed " << seed << " capture " << n + 1;
      EXPECT_NEAR(a.time, b.time, within) << "seed " << seed << " capture " << n + 1;
      ++compared;
    }
  }
  EXPECT_GE(compared, static_cast<int>(2 * kSeeds));
}

}  // namespace
}  // namespace colloid
