#include "statistics/proportion.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

namespace colloid::statistics {
namespace {

double binomial(std::size_t k, std::size_t n, double p) {
  const double hits = static_cast<double>(k);
  const double trials = static_cast<double>(n);
  return std::exp(std::lgamma(trials + 1.0) - std::lgamma(hits + 1.0) -
                  std::lgamma(trials - hits + 1.0) + hits * std::log(p) +
                  (trials - hits) * std::log1p(-p));
}

template <class IntervalOf>
double coverage(std::size_t n, double p, const IntervalOf& interval_of) {
  double covered = 0.0;
  for (std::size_t k = 0; k <= n; ++k) {
    const Proportion found = interval_of(k, n, 0.95);
    if (found.interval->low <= p && p <= found.interval->high) {
      covered += binomial(k, n, p);
    }
  }
  return covered;
}

// Enumerated, not simulated: the exact interval covers with at least its level for every
// p, each tail with at most half the rest; the score interval does so on average.
TEST(Proportion, CoverageByEnumeration) {
  for (std::size_t n : {1u, 5u, 20u, 50u}) {
    double wilson_mean = 0.0;
    for (int i = 1; i < 200; ++i) {
      const double p = i / 200.0;
      EXPECT_GE(coverage(n, p, clopper_pearson), 0.95 - 1e-12) << n << ' ' << p;
      wilson_mean += coverage(n, p, wilson) / 199.0;
    }
    EXPECT_NEAR(wilson_mean, 0.95, n == 1 ? 0.05 : 0.015) << n;
  }
}

TEST(Proportion, NoneAndAll) {
  EXPECT_FALSE(clopper_pearson(0, 0, 0.95).estimate);
  EXPECT_FALSE(wilson(0, 0, 0.95).interval);
  for (const auto& found : {clopper_pearson(0, 7, 0.95), wilson(0, 7, 0.95)}) {
    EXPECT_EQ(found.interval->low, 0.0);
    EXPECT_GT(found.interval->high, 0.2);
  }
  for (const auto& found : {clopper_pearson(7, 7, 0.95), wilson(7, 7, 0.95)}) {
    EXPECT_EQ(found.interval->high, 1.0);
    EXPECT_LT(found.interval->low, 0.8);
  }
}

TEST(Proportion, RefusesMoreHitsThanTrialsAndLevelsThatAreNone) {
  EXPECT_THROW(clopper_pearson(3, 2, 0.95), InvalidSample);
  EXPECT_THROW(wilson(1, 2, 0.0), InvalidSample);
}

}  // namespace
}  // namespace colloid::statistics
