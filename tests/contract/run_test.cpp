// What scripts of users rely on in `poreclog-solve run`: its JSON, its exit codes and the
// result file's names (interface keys), each checked on a run that clogs.
#include <nlohmann/json.hpp>

#include "run_scene.h"

namespace colloid {
namespace {

using Json = nlohmann::json;

TEST(Run, PrintsOneJsonObjectAndWritesTheResult) {
  const std::string scene = write_temporary("run.json", clogging_scene());
  const std::string result = temporary("run.h5");
  const Outcome outcome = run_program("run " + scene + " -o " + result +
                                      " --seed 18446744073709551615 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("schema_version"), 1);
  EXPECT_EQ(json.at("seed"), "18446744073709551615");
  EXPECT_EQ(json.at("tier"), "one_way");
  EXPECT_EQ(json.at("ending"), "duration");
  EXPECT_EQ(json.at("time_s"), 1.0);
  const Json& counts = json.at("counts");
  EXPECT_EQ(counts.at("injected").get<long>(),
            counts.at("delayed").get<long>() + counts.at("mobile").get<long>() +
                counts.at("retained").get<long>() + counts.at("traversed").get<long>());
  EXPECT_GT(counts.at("retained").get<long>(), 0);
  EXPECT_EQ(run_python("contract/run_names.py", result), 0);
}

TEST(Run, StopsWhenClogged) {
  const std::string scene =
      write_temporary("stop.json", clogging_scene("2 s", R"("stop_when": "clogged",)"));
  const std::string result = temporary("stop.h5");
  const Outcome outcome = run_program("run " + scene + " -o " + result + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("ending"), "clogged");
  EXPECT_EQ(json.at("time_s"), json.at("tc_s"));
  EXPECT_LT(json.at("tc_s").get<double>(), 2.0);
  EXPECT_LT(json.at("critical_diameter_m").get<double>(), 20e-6);
}

TEST(Run, ChoosesATierAndSaysWhy) {
  const std::string scene =
      write_temporary("auto.json", in_tier(clogging_scene("0.05 s"), "auto"));
  const Outcome outcome =
      run_program("run " + scene + " -o " + temporary("auto.h5") + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("tier"), "one_way");
  const auto reason = json.at("tier_reason").get<std::string>();
  EXPECT_NE(reason.find("Re_throat"), std::string::npos) << reason;
}

TEST(Run, ResolvesEveryColloidInTheTierQuasiSteady) {
  for (const std::string lubrication : {"full", "resolved_only"}) {
    std::string text = in_tier(clogging_scene("0.1 s"), "quasi_steady");
    text.replace(text.find(R"("hindrance": "wall")"), 19,
                 R"("lubrication": ")" + lubrication + R"(")");
    const std::string scene = write_temporary("resolved.json", text);
    const Outcome outcome =
        run_program("run " + scene + " -o " + temporary("resolved.h5") + " --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json.at("tier"), "quasi_steady");
    const Json& solver = json.at("solver");
    EXPECT_GT(solver.at("resolved_solves").get<double>(), 10.0);
    EXPECT_GE(solver.at("resolved_iterations"), solver.at("resolved_solves"));
    EXPECT_EQ(solver.at("overlaps"), 0.0);
  }
}

// Two colloids in the throat of the interface, one beside a grain, and none injected.
TEST(Run, StartsWithTheBodiesOfTheScene) {
  const std::string text = R"({"geometry": {"preset": "throat", "bodies": [
      {"center": ["48 um", "49 um", "100 um"], "diameter": "13.3 um"},
      {"center": ["48.3 um", "13.35 um", "72.45 um"], "diameter": "13.3 um"}]},
    "colloids": {"diameter": "13.3 um", "volume_fraction": 0},
    "drive": {"inlet_velocity": "0.5 mm/s"}, "duration": "0.4 s",
    "fidelity": {"tier": "one_way", "cells_per_colloid": 4}})";
  const std::string scene = write_temporary("bodies.json", text);
  const std::string result = temporary("bodies.h5");
  const Outcome outcome = run_program("run " + scene + " -o " + result + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json counts = Json::parse(outcome.out).at("counts");
  EXPECT_EQ(counts.at("injected"), 2);
  EXPECT_EQ(counts.at("traversed"), 1);
  EXPECT_EQ(counts.at("mobile").get<int>() + counts.at("retained").get<int>(), 1);
  EXPECT_EQ(run_python("contract/first_frame.py", result + " 48e-6,49e-6,100e-6 "
                                                           "48.3e-6,13.35e-6,72.45e-6"),
            0);

  const Outcome listed =
      run_program("describe --injections " + scene + " --seed 1 --json");
  ASSERT_EQ(listed.exit_code, 0) << listed.err;
  const Json injections = Json::parse(listed.out).at("injections");
  ASSERT_EQ(injections.size(), 2U);
  EXPECT_EQ(injections[1].at("index"), 1);
  EXPECT_EQ(injections[1].at("time_s"), 0.0);
  EXPECT_EQ(injections[1].at("position_m"), Json({48.3e-6, 13.35e-6, 72.45e-6}));
}

// The first of those two, pushed up harder than the stream carries it down (0.1 nN), or
// less; by both tiers.
TEST(Run, PushesTheBodiesOfTheScene) {
  for (const char* tier : {"one_way", "quasi_steady"}) {
    for (const auto& [push, traversed] : {std::pair{"0.5 nN", 0}, std::pair{"1 pN", 1}}) {
      const std::string text =
          std::string(R"({"geometry": {"preset": "throat", "bodies": [
      {"center": ["48 um", "49 um", "100 um"], "diameter": "13.3 um",
       "force": ["0 N", "0 N", ")") +
          push + R"("]}]},
    "colloids": {"diameter": "13.3 um", "volume_fraction": 0},
    "drive": {"inlet_velocity": "0.5 mm/s"}, "duration": "0.3 s",
    "fidelity": {"cells_per_colloid": 3, "tier": ")" +
          tier + "\"}}";
      const std::string scene = write_temporary("pushed.json", text);
      const Outcome outcome =
          run_program("run " + scene + " -o " + temporary("pushed.h5") + " --json");
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(Json::parse(outcome.out).at("counts").at("traversed"), traversed)
          << tier << " " << push;
    }
  }
}

// Colloids of 0.2 um: Pe below 100.
TEST(Run, RefusesBrownianMotionOfResolvedColloids) {
  const std::string scene = write_temporary("brownian.json", R"({"geometry": {
      "preset": "throat", "collector_diameter": "1.452 um", "height": "2.18 um"},
    "colloids": {"diameter": "200 nm", "volume_fraction": 0.001},
    "drive": {"inlet_velocity": "20 um/s"}, "duration": "0.01 s",
    "fidelity": {"tier": "quasi_steady", "cells_per_colloid": 3}})");
  const Outcome outcome = run_program("run " + scene + " -o " + temporary("brownian.h5"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("/fidelity/tier: the tier quasi_steady has no Brownian"),
            std::string::npos)
      << outcome.err;
}

TEST(Run, ShowsProgress) {
  const std::string scene = write_temporary("progress.json", clogging_scene("0.2 s"));
  const Outcome outcome =
      run_program("run " + scene + " -o " + temporary("progress.h5") + " --progress");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("0.200 of 0.2 s, "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(" retained, l_c "), std::string::npos);
  EXPECT_NE(outcome.err.find(" left"), std::string::npos);
}

}  // namespace
}  // namespace colloid
