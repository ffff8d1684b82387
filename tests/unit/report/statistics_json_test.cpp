// The statistics as JSON: numbers under their keys, null where the sample says nothing.
#include "report/statistics_json.h"

#include <cmath>

#include <gtest/gtest.h>

namespace colloid {
namespace {

using Json = nlohmann::ordered_json;
using statistics::RealisationOutcome;

RealisationOutcome outcome(std::uint64_t index, double t1, double tc, bool censored) {
  RealisationOutcome made;
  made.index = index;
  made.t1 = t1;
  made.end = 5.0;
  if (!censored) {
    made.tc = tc;
  }
  made.critical_diameter = {{0.0, tc, 5.0}, {40e-6, 10e-6, 10e-6}};
  made.permeability_ratio = {{0.0, tc, 5.0}, {1.0, 0.5, 0.5}};
  return made;
}

Json summary_of(const std::vector<RealisationOutcome>& outcomes) {
  statistics::SummaryOptions options;
  options.duration = 5.0;
  options.colloid_diameter = 13.3e-6;
  options.bootstrap.resamples = 200;
  return to_json(statistics::summarise(outcomes, options));
}

TEST(StatisticsJson, PutsNumbersUnderTheirKeys) {
  const Json json = summary_of({outcome(0, 0.5, 1.0, false), outcome(1, 0.7, 2.0, false),
                                outcome(2, 0.9, 3.0, false)});
  // Three numbers, two apart: mean 2, s = 1, half-width t_2 / sqrt 3 with
  // t_2(0.975) = 4.302653 (tables of Student's t).
  EXPECT_DOUBLE_EQ(json["tc"]["mean"].get<double>(), 2.0);
  EXPECT_DOUBLE_EQ(json["tc"]["sd"].get<double>(), 1.0);
  EXPECT_NEAR(json["tc"]["ci_low"].get<double>(), 2.0 - 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(json["tc"]["ci_high"].get<double>(), 2.0 + 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(json["t1"]["mean"].get<double>(), 0.7, 1e-12);
  EXPECT_NEAR(json["tc_minus_t1"]["mean"].get<double>(), 1.3, 1e-12);
  const Json& clogging = json["clogging"];
  EXPECT_EQ(clogging["median_s"], 2.0);
  EXPECT_EQ(clogging["probability_by_end"], 1.0);
  EXPECT_EQ(clogging["probability_ci"][1], 1.0);
  EXPECT_EQ(clogging["kaplan_meier"]["survival"].back(), 0.0);
  const Json& curves = json["curves"];
  EXPECT_EQ(curves["time_s"].back(), 5.0);
  EXPECT_EQ(curves["critical_diameter"]["mean"].front(), 40e-6);
  EXPECT_DOUBLE_EQ(curves["permeability_ratio"]["mean"].back().get<double>(), 0.5);
  for (const char* key : {"sd", "ci_low", "ci_high", "band_low", "band_high"}) {
    EXPECT_EQ(curves["critical_diameter"][key].size(), curves["time_s"].size()) << key;
  }
  EXPECT_FALSE(json["stages"]["end_of_second_s"].is_null());
}

TEST(StatisticsJson, HasNoMeanWhereARealisationIsCensored) {
  const Json json = summary_of({outcome(0, 0.5, 1.0, false), outcome(1, 0.7, 2.0, true)});
  EXPECT_EQ(json["n_censored"], 1);
  EXPECT_TRUE(json["tc"]["mean"].is_null());
  EXPECT_TRUE(json["tc_minus_t1"]["ci_low"].is_null());
  EXPECT_FALSE(json["tc"]["note"].get<std::string>().empty());
  // S falls to 1/2 at 1 s and stays: the area to 5 s is 1 + 4/2.
  EXPECT_DOUBLE_EQ(json["clogging"]["restricted_mean_s"].get<double>(), 3.0);
}

TEST(StatisticsJson, HasNoIntervalOfOneRealisation) {
  const Json json = summary_of({outcome(0, 0.5, 1.0, false)});
  EXPECT_EQ(json["tc"]["mean"], 1.0);
  for (const char* key : {"sd", "ci_low", "ci_high"}) {
    EXPECT_TRUE(json["tc"][key].is_null()) << key;
  }
}

TEST(StatisticsJson, OfNothingIsNullAndNotZero) {
  const Json json = summary_of({});
  EXPECT_EQ(json["n"], 0);
  EXPECT_TRUE(json["t1"]["mean"].is_null());
  EXPECT_TRUE(json["clogging"]["median_s"].is_null());
  EXPECT_TRUE(json["clogging"]["kaplan_meier"]["time_s"].empty());
  EXPECT_EQ(json.dump().find("nan"), std::string::npos);
}

TEST(StatisticsJson, ThinsSurvivalCurvesForPages) {
  std::vector<statistics::Observation> seen;
  for (int i = 0; i < 1000; ++i) {
    seen.push_back({0.001 * (i + 1), true});
  }
  const auto curve = statistics::kaplan_meier(seen, 0.95);
  const Json all = survival_json(curve, 0);
  const Json few = survival_json(curve, 100);
  EXPECT_EQ(all["time_s"].size(), curve.steps.size());
  EXPECT_LE(few["time_s"].size(), 102u);
  EXPECT_EQ(few["time_s"].front(), all["time_s"].front());
  EXPECT_EQ(few["time_s"].back(), all["time_s"].back());
  EXPECT_EQ(few["survival"].back(), 0.0);
}

}  // namespace
}  // namespace colloid
