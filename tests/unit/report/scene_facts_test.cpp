#include "report/scene_facts.h"

#include <gtest/gtest.h>

namespace colloid {
namespace {

using nlohmann::json;

TEST(SceneFacts, OfTheThroat) {
  const SceneFacts facts = scene_facts(json::parse(R"({
    "geometry": {"preset": "throat", "collector_diameter": "9.66e-05 m"},
    "colloids": {"diameter": "1.33e-05 m"}, "duration": "5 s", "stop_when": "clogged",
    "fidelity": {"capture_gap": "2e-07 m"}})"));
  EXPECT_EQ(facts.duration, 5.0);
  EXPECT_EQ(facts.colloid_diameter, 1.33e-5);
  ASSERT_TRUE(facts.inlet);
  EXPECT_EQ(facts.inlet->x.high, 9.66e-5);
  EXPECT_EQ(facts.inlet->y.high, 9.66e-5);
  EXPECT_DOUBLE_EQ(facts.inlet_margin, 0.5 * 1.33e-5 + 2e-7);
  EXPECT_TRUE(facts.stops_when_clogged);
}

TEST(SceneFacts, OfABox) {
  const json scene = json::parse(R"({
    "geometry": {"box": ["1e-04 m", "2e-04 m", "3e-04 m"],
                 "faces": {"z+": "inlet", "z-": "outlet"}},
    "fidelity": {"capture_gap": "computed"}, "stop_when": "duration"})");
  const SceneFacts facts = scene_facts(scene);
  ASSERT_TRUE(facts.inlet);
  EXPECT_EQ(facts.inlet->x.high, 1e-4);
  EXPECT_EQ(facts.inlet->y.high, 2e-4);
  EXPECT_EQ(facts.duration, std::nullopt);
  EXPECT_EQ(facts.inlet_margin, 0.0);
  EXPECT_FALSE(facts.stops_when_clogged);
  json sideways = scene;
  sideways["geometry"]["faces"] = {{"x-", "inlet"}, {"x+", "outlet"}};
  EXPECT_FALSE(scene_facts(sideways).inlet);
}

}  // namespace
}  // namespace colloid
