// `poreclog-solve describe --injections` as scripts see it: keys, types, order, SI, and
// that nothing but physics and seed counts.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.h"

namespace colloid {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kThroat = PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json";

std::string printed(const std::string& arguments) {
  const Outcome outcome = run_program("describe --injections " + arguments);
  EXPECT_EQ(outcome.exit_code, 0) << arguments << '\n' << outcome.err;
  EXPECT_EQ(outcome.err, "") << arguments;
  return outcome.out;
}

json injections(const std::string& scene, const std::string& seed) {
  const json document = json::parse(printed(scene + " --seed " + seed + " --json"));
  EXPECT_EQ(document.at("schema_version"), 1);
  EXPECT_EQ(document.at("seed"), json(seed));  // a text: 64 bits do not fit a number
  return document;
}

std::string throat_with(const json& changes, const std::string& name) {
  json scene = json::parse(content(kThroat));
  scene.merge_patch(changes);
  return write_temporary(name, scene.dump(1));
}

// Reference scene: 0.5 mm/s through 96.6 um squared, top of the colloid at 144.9 um.
// Counts: Poisson of mean 94.7; six standard deviations.
TEST(DescribeInjections, ListsIndexVolumeTimeAndPosition) {
  constexpr double kRadius = 6.65e-6;
  const json document = injections(kThroat, "18446744073709551615");
  const double flow_rate = document.at("flow_rate_m3_s").get<double>();
  EXPECT_NEAR(flow_rate / (0.5e-3 * 96.6e-6 * 96.6e-6), 1.0, 1e-12);
  EXPECT_NEAR(document.at("mean_rate_per_s").get<double>(), 18.94, 0.005);
  EXPECT_NEAR(document.at("inlet_area_m2").get<double>() / (96.6e-6 * 96.6e-6), 1.0,
              1e-12);
  EXPECT_NEAR(document.at("capture_gap_m").get<double>(), 13.3e-9, 0.1e-9);
  EXPECT_EQ(document.at("duration_s"), 5.0);
  EXPECT_THAT(document.at("time_from").get<std::string>(), HasSubstr("clean pore"));
  const json& list = document.at("injections");
  EXPECT_NEAR(static_cast<double>(list.size()), 94.7, 6.0 * std::sqrt(94.7));
  double before = 0.0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].at("index"), i);
    const double volume = list[i].at("volume_m3").get<double>();
    EXPECT_GT(volume, before);
    before = volume;
    EXPECT_DOUBLE_EQ(list[i].at("time_s").get<double>(), volume / flow_rate);
    EXPECT_LE(list[i].at("time_s").get<double>(), 5.0);
    EXPECT_GE(list[i].at("redraws").get<int>(), 0);
    const auto x = list[i].at("position_m").get<std::vector<double>>();
    ASSERT_EQ(x.size(), 3U);
    for (const std::size_t axis : {0U, 1U}) {
      EXPECT_GT(x[axis], kRadius);
      EXPECT_LT(x[axis], 96.6e-6 - kRadius);
    }
    EXPECT_NEAR(x[2], 144.9e-6 - kRadius, 1e-18);
  }
}

TEST(DescribeInjections, DependsOnTheSeedAlone) {
  const json one = injections(kThroat, "1");
  EXPECT_EQ(one, injections(kThroat, "1"));
  EXPECT_NE(one.at("injections"), injections(kThroat, "2").at("injections"));
  const std::string other = throat_with(
      {{"fidelity",
        {{"tier", "transient"}, {"cells_per_colloid", 3}, {"capture_gap", "1 um"}}}},
      "fidelity.json");
  EXPECT_EQ(one, injections(other, "1"));
}

TEST(DescribeInjections, LongerRunsContinueTheSameSequence) {
  const json five = injections(kThroat, "9").at("injections");
  const json twenty = injections(throat_with({{"duration", "20 s"}}, "longer.json"), "9")
                          .at("injections");
  ASSERT_GT(twenty.size(), five.size());
  for (std::size_t i = 0; i < five.size(); ++i) {
    EXPECT_EQ(five[i], twenty[i]);
  }
}

TEST(DescribeInjections, OfACleanLiquidIsEmpty) {
  const std::string clean =
      throat_with({{"colloids", {{"volume_fraction", 0}}}}, "clean.json");
  EXPECT_EQ(injections(clean, "1").at("injections"), json::array());
}

// At the default fidelity and below its limit of cells, the flow is that of `measure`.
TEST(DescribeInjections, SolvesTheFlowUnderAPressureDrop) {
  const std::string scene =
      throat_with({{"drive", {{"inlet_velocity", nullptr}, {"pressure_drop", "3 Pa"}}}},
                  "pressure.json");
  const json document = injections(scene, "4");
  const json measured = json::parse(run_program("measure " + scene).out);
  EXPECT_DOUBLE_EQ(document.at("flow_rate_m3_s").get<double>(),
                   measured.at("flow").at("flow_rate_m3_s").get<double>());
  EXPECT_DOUBLE_EQ(document.at("capture_gap_m").get<double>(),
                   measured.at("regime").at("capture_gap_m").get<double>());
  const json flux = injections(kThroat, "4").at("injections");
  const json& list = document.at("injections");
  ASSERT_GT(list.size(), flux.size());  // 1.4 times as fast
  for (std::size_t i = 0; i < flux.size(); ++i) {
    EXPECT_EQ(list[i].at("volume_m3"), flux[i].at("volume_m3"));
    EXPECT_LT(list[i].at("time_s"), flux[i].at("time_s"));
  }
}

TEST(DescribeInjections, WithoutJsonIsATable) {
  const std::string table = printed(kThroat + " --seed 3");
  EXPECT_THAT(table, HasSubstr("seed         3\n"));
  EXPECT_THAT(table, HasSubstr("mean rate    18.9383 colloids per second\n"));
  EXPECT_THAT(table, HasSubstr("index   volume [m3]    time [s]"));
  const std::size_t listed = injections(kThroat, "3").at("injections").size();
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
            listed + 7);
}

}  // namespace
}  // namespace colloid
