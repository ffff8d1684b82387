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
