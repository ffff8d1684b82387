#include "statistics/resampler.h"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/interval.h"

namespace colloid::statistics {
namespace {

TEST(Resampler, DrawsAsManyAsThereAre) {
  Resampler resampler(37, 5);
  for (int i = 0; i < 100; ++i) {
    const std::vector<std::uint32_t>& counts = resampler.draw();
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0u), 37u);
  }
  Resampler one(1, 5);
  EXPECT_EQ(one.draw(), std::vector<std::uint32_t>{1u});
}

// Each count is binomial with variance n (1 - 1/n) * draws; chi-square over 10 places has
// 9 degrees of freedom: 99.99 % below 33.7.
TEST(Resampler, DrawsEachEquallyOften) {
  constexpr int kDraws = 20000;
  Resampler resampler(10, 6);
  std::vector<double> total(10, 0.0);
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<std::uint32_t>& counts = resampler.draw();
    for (std::size_t k = 0; k < 10; ++k) {
      total[k] += counts[k];
    }
  }
  double chi_square = 0.0;
  for (double seen : total) {
    chi_square += (seen - kDraws) * (seen - kDraws) / kDraws;
  }
  EXPECT_LT(chi_square, 33.7);
  EXPECT_GT(chi_square, 0.5);
}

// Computed with MT19937-64 and SplitMix64 written out elsewhere from their papers; a
// change would change every published interval.
TEST(Resampler, IsTheSameForEver) {
  Resampler resampler(6, 1);
  EXPECT_EQ(resampler.draw(), (std::vector<std::uint32_t>{3u, 0u, 2u, 0u, 0u, 1u}));
  EXPECT_EQ(derive_seed(1, 0), 6791897765849424158u);
}

TEST(Resampler, SeedsOfDifferentUsesDiffer) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (std::uint64_t use = 0; use < 100; ++use) {
      seeds.insert(derive_seed(seed, use));
    }
  }
  EXPECT_EQ(seeds.size(), 5000u);
}

TEST(Resampler, RefusesAnEmptySample) {
  EXPECT_THROW(Resampler(0, 1), InvalidSample);
}

}  // namespace
}  // namespace colloid::statistics
