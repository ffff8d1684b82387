// Everything of one design point: counts, what is missing and why, and that each part
// gets the realisations that belong to it.
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace colloid::statistics {
namespace {

constexpr double kSide = 96.6e-6;

/// Clogs at 1 + index / 10 s; l_c falls from 40 um to 10 um then, k to half.
RealisationOutcome clogged(std::uint64_t index) {
  const double i = static_cast<double>(index);
  RealisationOutcome outcome;
  outcome.index = index;
  outcome.end = 5.0;
  outcome.t1 = 0.5 + 0.01 * i;
  outcome.tc = 1.0 + 0.1 * i;
  outcome.alpha_deg = 60.0 - 5.0 * i;
  outcome.diameter_lost = 2e-6;
  outcome.critical_diameter = {{0.0, *outcome.tc, 5.0}, {40e-6, 10e-6, 10e-6}};
  outcome.permeability_ratio = {{0.0, *outcome.tc, 5.0}, {1.0, 0.5, 0.5}};
  for (int k = 0; k < 5; ++k) {
    const double off = 1e-6 * (static_cast<double>(index % 7) * 4.0 + k);
    outcome.injection_positions.push_back({kSide / 2 + off, kSide / 2});
  }
  return outcome;
}

RealisationOutcome open(std::uint64_t index) {
  RealisationOutcome outcome = clogged(index);
  outcome.tc.reset();
  outcome.critical_diameter = {{0.0, 5.0}, {40e-6, 20e-6}};
  return outcome;
}

std::vector<RealisationOutcome> ensemble(std::size_t n) {
  std::vector<RealisationOutcome> outcomes;
  for (std::size_t i = 0; i < n; ++i) {
    outcomes.push_back(clogged(i));
  }
  return outcomes;
}

SummaryOptions options() {
  SummaryOptions options;
  options.duration = 5.0;
  options.colloid_diameter = 13.3e-6;
  options.inlet = Section{{0.0, kSide}, {0.0, kSide}};
  options.grid_points = 51;
  options.bootstrap.resamples = 200;
  return options;
}

TEST(Summary, OfACompleteEnsemble) {
  const PointStatistics point = summarise(ensemble(11), options());
  EXPECT_EQ(point.n, 11u);
  EXPECT_EQ(point.n_censored, 0u);
  EXPECT_EQ(point.level, 0.95);
  EXPECT_TRUE(point.warnings.empty());
  EXPECT_NEAR(*point.t1.student.mean, 0.55, 1e-12);
  EXPECT_NEAR(*point.tc.student.mean, 1.5, 1e-12);
  EXPECT_NEAR(*point.tc_minus_t1.student.mean, 0.95, 1e-12);
  ASSERT_TRUE(point.tc.student.interval && point.tc.bootstrap.bca);
  EXPECT_NEAR(*point.median_t1.estimate, 0.55, 1e-12);
  EXPECT_NEAR(*point.clogging.median.estimate, 1.5, 1e-12);
  EXPECT_NEAR(*point.clogging.restricted_mean->mean, 1.5, 1e-12);
  EXPECT_EQ(*point.clogging.probability_by_end->estimate, 1.0);
  ASSERT_EQ(point.curves.time.size(), 51u);
  EXPECT_NEAR(point.curves.critical_diameter.mean.front(), 40e-6, 1e-18);
  EXPECT_NEAR(point.curves.critical_diameter.mean.back(), 10e-6, 1e-18);
  EXPECT_NEAR(point.curves.permeability_ratio.mean[15], (6 * 0.5 + 5) / 11, 1e-12);
  // t_c - t_1 = 0.5 + 0.09 i and alpha = 60 - 5 i: slope -0.018 s per degree.
  EXPECT_NEAR(*point.alpha_fit.line.slope, -0.018, 1e-12);
  EXPECT_NEAR(*point.alpha_fit.line.intercept, 0.5 + 0.018 * 60.0, 1e-12);
  EXPECT_FALSE(point.alpha_fit.with_censored);
  EXPECT_EQ(point.alpha_fit.points.size(), 11u);
  ASSERT_EQ(point.injection.size(), 5u);
  EXPECT_EQ(point.injection[4].order, 5u);
  EXPECT_EQ(point.injection[0].n, 11u);
}

// All have clogged by 2.0 s, and the mean falls below 13.3 um between 1.9 s (one of 11 is
// open: 12.7 um) and the grid time before, 1.8 s (two: 15.5 um).
TEST(Summary, StagesOfACompleteEnsemble) {
  const PointStatistics point = summarise(ensemble(11), options());
  EXPECT_NEAR(*point.stages.end_of_first, 0.55, 1e-12);
  const double at_18 = (9 * 10e-6 + 2 * 40e-6) / 11;
  const double at_19 = (10 * 10e-6 + 40e-6) / 11;
  EXPECT_NEAR(*point.stages.end_of_second,
              1.8 + 0.1 * (at_18 - 13.3e-6) / (at_18 - at_19), 1e-9);
  ASSERT_TRUE(point.stages.end_of_third);
  EXPECT_NEAR(*point.stages.end_of_third, 2.0, 1e-9);
}

TEST(Summary, OneCensoredRealisationTakesTheMeanAway) {
  std::vector<RealisationOutcome> outcomes = ensemble(11);
  outcomes[3] = open(3);
  const PointStatistics point = summarise(outcomes, options());
  EXPECT_EQ(point.n_censored, 1u);
  EXPECT_TRUE(point.t1.student.mean);
  EXPECT_FALSE(point.tc.student.mean);
  EXPECT_FALSE(point.tc.bootstrap.bca);
  EXPECT_FALSE(point.tc_minus_t1.student.mean);
  EXPECT_EQ(point.tc.student.n, 11u);
  EXPECT_NE(point.tc.student.note.find("1 of 11"), std::string::npos);
  EXPECT_NEAR(*point.clogging.restricted_mean->mean, (11 * 1.5 - 1.3 + 5.0) / 11, 1e-12);
  EXPECT_NEAR(*point.clogging.probability_by_end->estimate, 10.0 / 11.0, 1e-15);
  EXPECT_EQ(point.alpha_fit.line.n, 10u);
  EXPECT_EQ(point.alpha_fit.n_excluded, 1u);
  ASSERT_TRUE(point.alpha_fit.with_censored);
  EXPECT_EQ(point.alpha_fit.with_censored->n_censored, 1u);
}

TEST(Summary, FailedRealisationsAreCountedAloudAndNotCensored) {
  std::vector<RealisationOutcome> outcomes = ensemble(11);
  outcomes[3] = RealisationOutcome();
  outcomes[3].index = 3;
  outcomes[3].progress = Progress::failed;
  const PointStatistics point = summarise(outcomes, options());
  EXPECT_EQ(point.n, 10u);
  EXPECT_EQ(point.n_failed, 1u);
  EXPECT_EQ(point.n_censored, 0u);
  EXPECT_TRUE(point.tc.student.mean);
  ASSERT_EQ(point.warnings.size(), 1u);
  EXPECT_NE(point.warnings[0].find("1 of 11 realisations failed"), std::string::npos);
}

TEST(Summary, WhileOthersRunMeansAreOfThePrefixAndSurvivalOfAllStarted) {
  std::vector<RealisationOutcome> outcomes = ensemble(11);
  outcomes[6].progress = Progress::running;
  outcomes[6].tc.reset();
  outcomes[6].end = 1.2;
  outcomes[10].progress = Progress::pending;
  const PointStatistics point = summarise(outcomes, options());
  EXPECT_EQ(point.n, 6u);
  EXPECT_EQ(point.n_running, 1u);
  EXPECT_EQ(point.n_pending, 1u);
  EXPECT_EQ(point.n_beyond_prefix, 3u);
  EXPECT_EQ(point.n_censored, 0u);
  EXPECT_NEAR(*point.tc.student.mean, 1.25, 1e-12);
  EXPECT_EQ(point.curves.critical_diameter.n, 6u);
  EXPECT_EQ(point.clogging.kaplan_meier.n, 10u);
  EXPECT_EQ(point.clogging.kaplan_meier.n_events, 9u);
  EXPECT_EQ(point.median_t1.n, 10u);
  ASSERT_EQ(point.warnings.size(), 1u);
  EXPECT_NE(point.warnings[0].find("interim"), std::string::npos);
}

TEST(Summary, DoesNotDependOnTheOrderGiven) {
  std::vector<RealisationOutcome> outcomes = ensemble(9);
  const PointStatistics sorted = summarise(outcomes, options());
  std::reverse(outcomes.begin(), outcomes.end());
  const PointStatistics reversed = summarise(outcomes, options());
  EXPECT_EQ(sorted.tc.bootstrap.bca->low, reversed.tc.bootstrap.bca->low);
  EXPECT_EQ(sorted.curves.critical_diameter.band[20].low,
            reversed.curves.critical_diameter.band[20].low);
}

TEST(Summary, OfNoneAndOne) {
  const PointStatistics none = summarise({}, options());
  EXPECT_EQ(none.n, 0u);
  EXPECT_FALSE(none.t1.student.mean);
  EXPECT_TRUE(none.curves.time.empty());
  EXPECT_FALSE(none.stages.end_of_first);
  const PointStatistics one = summarise(ensemble(1), options());
  EXPECT_EQ(*one.tc.student.mean, 1.0);
  EXPECT_FALSE(one.tc.student.interval);
  EXPECT_TRUE(one.curves.critical_diameter.band.empty());
  EXPECT_FALSE(one.alpha_fit.line.slope);
  EXPECT_FALSE(one.injection[0].probability_fit.rate_interval);
}

TEST(Summary, OfAllCensoredWithNothingRetained) {
  std::vector<RealisationOutcome> outcomes;
  for (std::uint64_t i = 0; i < 20; ++i) {
    RealisationOutcome outcome;
    outcome.index = i;
    outcome.end = 5.0 * (1.0 - 1e-13);  // a last step short by round-off
    outcome.critical_diameter = {{0.0, outcome.end}, {40e-6, 40e-6}};
    outcomes.push_back(outcome);
  }
  const PointStatistics point = summarise(outcomes, options());
  EXPECT_EQ(point.n_censored, 20u);
  EXPECT_FALSE(point.t1.student.mean);
  EXPECT_FALSE(point.stages.end_of_first);
  EXPECT_FALSE(point.stages.end_of_second);
  EXPECT_FALSE(point.stages.end_of_third);
  EXPECT_EQ(*point.clogging.restricted_mean->mean, 5.0);
  EXPECT_EQ(*point.clogging.probability_by_end->estimate, 0.0);
  EXPECT_EQ(point.injection[0].n_without, 20u);
  EXPECT_TRUE(point.warnings.empty());
}

// A table of times alone, as from another program.
TEST(Summary, WithoutDurationAndCurves) {
  std::vector<RealisationOutcome> outcomes;
  for (std::uint64_t i = 0; i < 4; ++i) {
    RealisationOutcome outcome;
    outcome.index = i;
    outcome.tc = 1.0 + static_cast<double>(i);
    outcome.end = *outcome.tc;
    outcomes.push_back(outcome);
  }
  SummaryOptions bare;
  bare.bootstrap.resamples = 100;
  const PointStatistics point = summarise(outcomes, bare);
  EXPECT_EQ(point.clogging.restricted_mean->tau, 4.0);
  ASSERT_EQ(point.warnings.size(), 1u);
  EXPECT_NE(point.warnings[0].find("no duration"), std::string::npos);
  EXPECT_TRUE(point.curves.time.empty());
  EXPECT_TRUE(point.injection.empty());
}

TEST(Summary, CurvesOfRunsThatStopWhenCloggedAreHeldOrCutAloud) {
  std::vector<RealisationOutcome> outcomes = ensemble(4);
  for (RealisationOutcome& outcome : outcomes) {
    outcome.end = *outcome.tc;
    outcome.critical_diameter = {{0.0, *outcome.tc}, {40e-6, 10e-6}};
    outcome.permeability_ratio = {{0.0, *outcome.tc}, {1.0, 0.5}};
  }
  const PointStatistics cut = summarise(outcomes, options());
  EXPECT_EQ(cut.curves.time.back(), 1.0);
  EXPECT_EQ(cut.warnings.size(), 1u);
  SummaryOptions holding = options();
  holding.hold_last = true;
  const PointStatistics held = summarise(outcomes, holding);
  EXPECT_EQ(held.curves.time.back(), 5.0);
  EXPECT_EQ(held.warnings.size(), 1u);
  EXPECT_NEAR(held.curves.critical_diameter.mean.back(), 10e-6, 1e-18);
}

TEST(Summary, RefusesWhatIsNoOutcomeAndNamesTheRealisation) {
  std::vector<RealisationOutcome> outcomes = ensemble(3);
  const auto refused = [&outcomes] {
    try {
      summarise(outcomes, options());
    } catch (const InvalidSample& error) {
      return std::string(error.what()).find("realisation 1") != std::string::npos;
    }
    return false;
  };
  outcomes[1].t1 = std::nan("");
  EXPECT_TRUE(refused());
  outcomes[1] = clogged(1);
  outcomes[1].tc = 6.0;  // after its end
  EXPECT_TRUE(refused());
  outcomes[1] = clogged(1);
  outcomes[1].permeability_ratio.value[1] = std::nan("");
  EXPECT_TRUE(refused());
  outcomes[1] = clogged(1);
  outcomes[0].index = 1;
  EXPECT_TRUE(refused());
}

}  // namespace
}  // namespace colloid::statistics
