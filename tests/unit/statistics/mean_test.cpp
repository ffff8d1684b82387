// Mean with Student's interval, and the bootstrap: the small, the equal, the refused.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/bootstrap.h"
#include "statistics/mean_interval.h"

namespace colloid::statistics {
namespace {

TEST(MeanInterval, OfNoneOneAndTwo) {
  const MeanInterval none = mean_interval({}, 0.95);
  EXPECT_FALSE(none.mean);
  EXPECT_FALSE(none.note.empty());
  const MeanInterval one = mean_interval({3.0}, 0.95);
  EXPECT_EQ(*one.mean, 3.0);
  EXPECT_FALSE(one.sd);
  EXPECT_FALSE(one.interval);
  // t_1 is Cauchy: its 97.5 % quantile is tan(0.475 pi); s / sqrt 2 = 1.
  const MeanInterval two = mean_interval({2.0, 4.0}, 0.95);
  EXPECT_NEAR(two.interval->high - 3.0, std::tan(0.475 * 3.14159265358979324), 1e-11);
  EXPECT_NEAR(*two.sd, std::sqrt(2.0), 1e-15);
}

TEST(MeanInterval, OfEqualValuesSaysThatItHasNoWidth) {
  const MeanInterval found = mean_interval({0.1, 0.1, 0.1}, 0.95);
  EXPECT_NEAR(found.interval->high - found.interval->low, 0.0, 1e-15);
  EXPECT_FALSE(found.note.empty());
}

TEST(MeanInterval, KeepsItsDigitsFarFromZero) {
  const MeanInterval found = mean_interval({1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0}, 0.95);
  EXPECT_NEAR(*found.sd, 1.0, 1e-12);
}

TEST(MeanInterval, RefusesWhatIsNoNumber) {
  EXPECT_THROW(mean_interval({1.0, std::nan("")}, 0.95), InvalidSample);
  EXPECT_THROW(mean_interval({1.0, HUGE_VAL}, 0.95), InvalidSample);
  EXPECT_THROW(mean_interval({1.0, 2.0}, 95.0), InvalidSample);
}

double largest(const std::vector<double>& sample) {
  return *std::max_element(sample.begin(), sample.end());
}

TEST(Bootstrap, SaysWhereItIsDegenerate) {
  EXPECT_FALSE(bootstrap_mean({}, {}).percentile);
  EXPECT_FALSE(bootstrap_mean({1.0}, {}).percentile);
  const BootstrapIntervals equal = bootstrap_mean({0.1, 0.1, 0.1, 0.1}, {});
  EXPECT_FALSE(equal.percentile);
  EXPECT_FALSE(equal.bca);
  EXPECT_NE(equal.note.find("degenerate"), std::string::npos);
  EXPECT_THROW(bootstrap_mean({1.0, std::nan("")}, {}), InvalidSample);
}

// Replicates of a maximum never exceed it; ties count half, so z0 is finite here, and the
// jackknife values differ in one only.
TEST(Bootstrap, OfAMaximumHasABiasCorrection) {
  const BootstrapIntervals found = bootstrap({1.0, 2.0, 4.0, 9.0}, largest, {});
  ASSERT_TRUE(found.bias_correction);
  // P(maximum drawn) = 1 - (3/4)^4 = 0.6836: the share below is 0.3164 + 0.3418 = 0.6582,
  // +- 4 * 0.0052 (the ties' half has half the binomial's error); Phi^-1 of it 0.407.
  EXPECT_NEAR(*found.bias_correction, 0.4075, 0.06);
}

TEST(Bootstrap, ReplicatesOnOneSideLeaveBcaUndefined) {
  const BootstrapIntervals found =
      bootstrap_intervals(0.0, {1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 0.95);
  EXPECT_TRUE(found.percentile);
  EXPECT_FALSE(found.bca);
  EXPECT_FALSE(found.note.empty());
}

TEST(Bootstrap, DependsOnTheSeedAlone) {
  const std::vector<double> sample{1.0, 2.5, 0.3, 7.7, 4.2, 3.1};
  BootstrapOptions options;
  options.seed = 42;
  const BootstrapIntervals once = bootstrap_mean(sample, options);
  const BootstrapIntervals again = bootstrap_mean(sample, options);
  EXPECT_EQ(once.bca->low, again.bca->low);
  options.seed = 43;
  EXPECT_NE(*once.bias_correction, *bootstrap_mean(sample, options).bias_correction);
}

// The mean's shortcut for the jackknife is the jackknife.
TEST(Bootstrap, MeanIsTheGeneralBootstrapOfTheMean) {
  const std::vector<double> sample{1.0, 2.5, 0.3, 7.7, 4.2, 3.1};
  const auto mean = [](const std::vector<double>& x) {
    return *mean_interval(x, 0.95).mean;
  };
  const BootstrapIntervals quick = bootstrap_mean(sample, {});
  const BootstrapIntervals general = bootstrap(sample, mean, {});
  EXPECT_NEAR(*quick.acceleration, *general.acceleration, 1e-13);
  EXPECT_NEAR(quick.bca->low, general.bca->low, 1e-12);
}

}  // namespace
}  // namespace colloid::statistics
