// Kaplan-Meier, median, restricted mean and probability by a time, where no package's
// answer is the reference: small, equal, all or none censored.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/event_probability.h"
#include "statistics/kaplan_meier.h"
#include "statistics/restricted_mean.h"

namespace colloid::statistics {
namespace {

constexpr double kNone = 0.025;  // the tail in which no event of n is excluded

TEST(KaplanMeier, NoRealisationHasNoCurve) {
  const KaplanMeier curve = kaplan_meier({}, 0.95);
  EXPECT_TRUE(curve.steps.empty());
  EXPECT_EQ(step_at(curve, 1.0), nullptr);
  EXPECT_FALSE(median_time(curve).estimate);
  EXPECT_FALSE(restricted_mean(curve, 1.0).mean);
  EXPECT_FALSE(event_probability({}, 1.0, 0.95).estimate);
}

// Chance of no event in n when each survives with S: S^n; S^n = 0.025 bounds S below.
TEST(KaplanMeier, WithoutAnEventTheBoundIsExactAndNotOfZeroWidth) {
  const KaplanMeier curve = kaplan_meier({{5, false}, {5, false}, {5, false}}, 0.95);
  ASSERT_EQ(curve.steps.size(), 2u);
  EXPECT_EQ(curve.n_events, 0u);
  for (const SurvivalStep& step : curve.steps) {
    EXPECT_EQ(step.survival, 1.0);
    EXPECT_NEAR(step.interval.low, std::pow(kNone, 1.0 / 3.0), 1e-12);
    EXPECT_EQ(step.interval.high, 1.0);
  }
  const MedianTime median = median_time(curve);
  EXPECT_FALSE(median.estimate);
  EXPECT_FALSE(median.high);
  ASSERT_TRUE(median.low);  // three survivors do not exclude a median below 5
  EXPECT_EQ(*median.low, 0.0);
}

TEST(KaplanMeier, ManySurvivorsExcludeAnEarlyMedian) {
  const MedianTime median =
      median_time(kaplan_meier(std::vector<Observation>(20, {5, false}), 0.95));
  EXPECT_FALSE(median.low);
  EXPECT_FALSE(median.estimate);
  EXPECT_FALSE(median.high);
}

TEST(KaplanMeier, WhenAllHadTheEventTheUpperBoundIsExact) {
  std::vector<Observation> observations;
  for (int i = 1; i <= 8; ++i) {
    observations.push_back({static_cast<double>(i), true});
  }
  const KaplanMeier curve = kaplan_meier(observations, 0.95);
  const SurvivalStep& last = curve.steps.back();
  EXPECT_EQ(last.survival, 0.0);
  EXPECT_EQ(last.interval.low, 0.0);
  EXPECT_NEAR(last.interval.high, 1.0 - std::pow(kNone, 1.0 / 8.0), 1e-12);
}

TEST(KaplanMeier, AfterCensoringTheLastEventKeepsTheUpperLimitBefore) {
  const KaplanMeier curve =
      kaplan_meier({{1, true}, {2, true}, {3, false}, {4, true}}, 0.95);
  ASSERT_EQ(curve.steps.size(), 5u);
  EXPECT_EQ(curve.steps[4].survival, 0.0);
  EXPECT_EQ(curve.steps[4].interval.high, curve.steps[3].interval.high);
  EXPECT_GT(curve.steps[4].interval.high, 0.5);
}

// Three at risk at 2 although one of them leaves then: S = 2/3, not 1/2.
TEST(KaplanMeier, AnEventComesBeforeACensoringAtTheSameTime) {
  const KaplanMeier curve = kaplan_meier({{2, false}, {2, true}, {3, true}}, 0.95);
  ASSERT_EQ(curve.steps.size(), 3u);
  EXPECT_EQ(curve.steps[1].at_risk, 3u);
  EXPECT_EQ(curve.steps[1].events, 1u);
  EXPECT_EQ(curve.steps[1].censored, 1u);
  EXPECT_NEAR(curve.steps[1].survival, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(curve.steps[2].at_risk, 1u);
}

TEST(KaplanMeier, OneRealisation) {
  const KaplanMeier event = kaplan_meier({{2, true}}, 0.95);
  EXPECT_NEAR(event.steps.back().interval.high, 0.975, 1e-12);
  EXPECT_EQ(*median_time(event).estimate, 2.0);
  EXPECT_FALSE(median_time(event).high);
  const KaplanMeier censored = kaplan_meier({{2, false}}, 0.95);
  EXPECT_NEAR(censored.steps.back().interval.low, 0.025, 1e-12);
}

TEST(KaplanMeier, AllEqual) {
  const KaplanMeier curve = kaplan_meier(std::vector<Observation>(6, {1.5, true}), 0.95);
  ASSERT_EQ(curve.steps.size(), 2u);
  EXPECT_EQ(curve.steps[1].survival, 0.0);
  EXPECT_EQ(*median_time(curve).estimate, 1.5);
  const RestrictedMean mean = restricted_mean(curve, 3.0);
  EXPECT_EQ(*mean.mean, 1.5);
  EXPECT_FALSE(mean.interval);
  EXPECT_FALSE(mean.note.empty());
}

// Products of ratios give 1/2 an ulp too high: 4 events, 2 gone, S = 3/4 * 2/3.
TEST(KaplanMeier, MedianIsTheFirstTimeAtWhichHalfAreLeft) {
  for (int n : {2, 4, 6, 10, 14, 22, 98}) {
    std::vector<Observation> observations;
    for (int i = 1; i <= n; ++i) {
      observations.push_back({static_cast<double>(i), true});
    }
    EXPECT_EQ(*median_time(kaplan_meier(observations, 0.95)).estimate, n / 2) << n;
  }
}

TEST(KaplanMeier, EventAtTimeZero) {
  const KaplanMeier curve = kaplan_meier({{0, true}, {1, true}}, 0.95);
  ASSERT_EQ(curve.steps.size(), 2u);
  EXPECT_EQ(curve.steps[0].time, 0.0);
  EXPECT_EQ(curve.steps[0].survival, 0.5);
}

TEST(KaplanMeier, RefusesTimesThatAreNone) {
  EXPECT_THROW(kaplan_meier({{std::nan(""), true}}, 0.95), InvalidSample);
  EXPECT_THROW(kaplan_meier({{HUGE_VAL, false}}, 0.95), InvalidSample);
  EXPECT_THROW(kaplan_meier({{-1.0, true}}, 0.95), InvalidSample);
  EXPECT_THROW(kaplan_meier({{1.0, true}}, 1.0), InvalidSample);
  EXPECT_THROW(kaplan_meier({{1.0, true}}, std::nan("")), InvalidSample);
}

// Uncensored before tau, the restricted mean is the mean, and its variance that of the
// mean with n in place of n - 1.
TEST(RestrictedMean, WithoutCensoringIsTheMean) {
  const std::vector<double> times{1.0, 2.0, 2.0, 4.0, 7.0};
  std::vector<Observation> observations;
  for (double t : times) {
    observations.push_back({t, true});
  }
  const RestrictedMean found = restricted_mean(kaplan_meier(observations, 0.95), 10.0);
  EXPECT_NEAR(*found.mean, 3.2, 1e-14);
  const double squares = 2.2 * 2.2 + 1.2 * 1.2 + 1.2 * 1.2 + 0.8 * 0.8 + 3.8 * 3.8;
  EXPECT_NEAR(*found.standard_error, std::sqrt(squares / 5.0 / 5.0), 1e-14);
}

TEST(RestrictedMean, AllCensoredAtTheDeadline) {
  const RestrictedMean found =
      restricted_mean(kaplan_meier(std::vector<Observation>(10, {5, false}), 0.95), 5.0);
  EXPECT_EQ(*found.mean, 5.0);
  EXPECT_FALSE(found.standard_error);
  ASSERT_TRUE(found.interval);
  EXPECT_EQ(found.interval->high, 5.0);
  EXPECT_NEAR(found.interval->low, 5.0 * std::pow(kNone, 0.1), 1e-12);
}

// Two of the ten left at 1 and say nothing about 5.
TEST(RestrictedMean, EarlyLeaversDoNotSharpenTheBound) {
  std::vector<Observation> observations(8, {5, false});
  observations.resize(10, {1, false});
  const RestrictedMean found = restricted_mean(kaplan_meier(observations, 0.95), 5.0);
  EXPECT_NEAR(found.interval->low, 5.0 * std::pow(kNone, 1.0 / 8.0), 1e-12);
}

// "No event by tau" would be false, and its bound with it.
TEST(RestrictedMean, AnEventAtTauItselfIsAnEvent) {
  const RestrictedMean found =
      restricted_mean(kaplan_meier({{5, true}, {6, false}, {6, false}}, 0.95), 5.0);
  EXPECT_DOUBLE_EQ(*found.mean, 5.0);
  EXPECT_FALSE(found.interval);
  EXPECT_FALSE(found.note.empty());
}

TEST(RestrictedMean, IsUnknownBeyondTheLastFollowed) {
  const RestrictedMean found =
      restricted_mean(kaplan_meier({{1, true}, {2, false}}, 0.95), 5.0);
  EXPECT_FALSE(found.mean);
  EXPECT_FALSE(found.note.empty());
  // Once all had the event, S is 0 from there on.
  EXPECT_NEAR(*restricted_mean(kaplan_meier({{1, true}, {2, true}}, 0.95), 5.0).mean, 1.5,
              1e-15);
}

TEST(RestrictedMean, StaysWithinTau) {
  std::vector<Observation> observations(20, {5, false});
  observations.push_back({0.1, true});
  const RestrictedMean found = restricted_mean(kaplan_meier(observations, 0.95), 5.0);
  EXPECT_EQ(found.interval->high, 5.0);
  EXPECT_THROW(restricted_mean(kaplan_meier({}, 0.95), 0.0), InvalidSample);
}

TEST(EventProbability, IsBinomialIfNobodyLeftBefore) {
  const std::vector<Observation> observations{
      {1, true}, {5, false}, {5, false}, {5, true}, {7, true}};
  const EventProbability found = event_probability(observations, 5.0, 0.95);
  EXPECT_EQ(found.method, "Clopper-Pearson");
  EXPECT_EQ(*found.estimate, 0.4);
}

TEST(EventProbability, IsKaplanMeierIfSomebodyDid) {
  const std::vector<Observation> observations{
      {1, true}, {2, false}, {3, true}, {5, false}, {5, false}};
  const EventProbability found = event_probability(observations, 5.0, 0.95);
  EXPECT_NEAR(*found.estimate, 1.0 - 0.8 * 2.0 / 3.0, 1e-15);
  const KaplanMeier curve = kaplan_meier(observations, 0.95);
  const SurvivalStep* step = step_at(curve, 5.0);
  ASSERT_NE(step, nullptr);
  EXPECT_EQ(found.interval->low, 1.0 - step->interval.high);
  EXPECT_FALSE(event_probability(observations, 6.0, 0.95).estimate);
}

TEST(EventProbability, WithoutAnEventCountsThoseFollowed) {
  std::vector<Observation> observations(8, {5, false});
  observations.resize(10, {1, false});
  const EventProbability found = event_probability(observations, 5.0, 0.95);
  EXPECT_EQ(*found.estimate, 0.0);
  EXPECT_NEAR(found.interval->high, 1.0 - std::pow(kNone, 1.0 / 8.0), 1e-12);
}

// What the censoring is for: one in five never clogs, the others at T = 1 + an
// exponential of mean 1, the deadline is 5.  E min(T, 5) = 0.8 (2 - e^-4) + 0.2 * 5,
// while the mean over those that clogged is 2 - 4 e^-4 / (1 - e^-4) = 1.925, a quarter
// too low.  T takes its 800 quantiles, whose mean misses the integral by no more than the
// first's share of the tail.
TEST(RestrictedMean, CountsTheRealisationsThatNeverClog) {
  std::vector<Observation> observations;
  double sum = 0.0;
  int clogged = 0;
  for (int i = 0; i < 4000; ++i) {
    const double u = (i / 5 + 0.5) / 800.0;
    const double t = i % 5 == 0 ? HUGE_VAL : 1.0 - std::log(u);
    observations.push_back({std::min(t, 5.0), t <= 5.0});
    sum += t <= 5.0 ? t : 0.0;
    clogged += t <= 5.0 ? 1 : 0;
  }
  const RestrictedMean found = restricted_mean(kaplan_meier(observations, 0.95), 5.0);
  EXPECT_NEAR(*found.mean, 0.8 * (2.0 - std::exp(-4.0)) + 1.0, 2e-3);
  EXPECT_NEAR(sum / clogged, 2.0 - 4.0 * std::exp(-4.0) / (1.0 - std::exp(-4.0)), 1e-2);
}

}  // namespace
}  // namespace colloid::statistics
