// Campaign files, seeds, plans and what may change between two runs.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/hash.h"
#include "campaign/changes.h"
#include "campaign/plan.h"
#include "campaign/read_campaign.h"
#include "campaign/seed.h"
#include "campaign/solver_program.h"

namespace colloid {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::string campaign_with(const std::string& keys) {
  return "{\"campaign\": \"c\", \"scene\": {}, \"realisations\": 3, \"master_seed\": 1" +
         (keys.empty() ? "" : ",\n" + keys) + "}";
}

std::string refusal(const std::string& text) {
  try {
    parse_campaign(text, "c.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Campaign, IsRefusedWithPlaceExpectationAndNearestKey) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("realizations": 3)",
       "c.json line 2, column 1: /realizations: is not a known key here; the nearest is "
       "\"realisations\""},
      {R"("limits": {"atempts": 2})",
       "c.json line 2, column 12: /limits/atempts: is not a known key here; the nearest "
       "is "
       "\"attempts\""},
      {R"("limits": {"attempts": 0})",
       "/limits/attempts: is the number 0, expected an integer in [1, 1000]"},
      {R"("limits": {"attempts": 1e300})", "/limits/attempts: is the number 1e+300"},
      {R"("limits": {"checkpoint_interval": "60 s"})",
       "/limits/checkpoint_interval: is the text \"60 s\", expected a number in [0, "
       "1000000000]"},
      {R"("limits": {"workers": 1.5})", "/limits/workers: is the number 1.5"},
      {R"("executor": "slrum")", "/executor: is \"slrum\", expected"},
      {R"("fidelity": {"tier": "oneway"})", "the nearest is \"one_way\""},
      {R"("fidelity": {"tier": []})", "/fidelity/tier: is an empty list"},
      {R"("fidelity": {"tier": ["auto", "auto"]})", "/fidelity/tier/1: is given twice"},
      {R"("vary": {"colloids": [1]})", "/vary/colloids: is not a JSON pointer"},
      {R"("vary": {"/colloids/diameter": []})",
       "/vary/~1colloids~1diameter: is a list of 0"},
      {R"("vary": {"/a": [1, 2, 1]})", "/vary/~1a/2: is given twice"},
      {R"("vary": {"/fidelity/tier": ["auto"]})", "give a list in /fidelity/tier"},
      {R"("vary": {"/a": [1], "/a/b": [2]})", "lies within"},
      {R"("independent_points": 1)", "expected true or false"},
      {R"("statistics": {"confidence": 95})", "expected a number in [0.5, 0.9999]"},
  };
  for (const auto& [keys, why] : cases) {
    EXPECT_THAT(refusal(campaign_with(keys)), HasSubstr(why)) << keys;
  }
  EXPECT_THAT(
      refusal(campaign_with(R"("realizations": 3)")),
      HasSubstr("known: campaign, description, scene, realisations, master_seed"));
  EXPECT_THAT(refusal("{\"campaign\": \"c\", \"scene\": \"/\", \"realisations\": 3, "
                      "\"master_seed\": 1}"),
              HasSubstr("column 19: /scene: there is no file \"/\""));
  EXPECT_THAT(refusal("{}"), HasSubstr("has no key \"campaign\", which is required"));
  EXPECT_THAT(refusal("[]"), HasSubstr("expected an object"));
  EXPECT_EQ(refusal(campaign_with("")), "");
}

TEST(Campaign, TakesSeedsOf64BitsAndNoOthers) {
  const auto with_seed = [](const std::string& seed) {
    return "{\"campaign\": \"c\", \"scene\": {}, \"realisations\": 3, \"master_seed\": " +
           seed + "}";
  };
  for (const char* good : {"0", "18446744073709551615", "\"18446744073709551615\""}) {
    EXPECT_EQ(refusal(with_seed(good)), "") << good;
  }
  for (const char* bad : {"-1", "18446744073709551616", "\"18446744073709551616\"", "1.0",
                          "\"01\"", "\"\"", "\" 1\"", "\"0x1\"", "null", "1e3"}) {
    EXPECT_THAT(refusal(with_seed(bad)), HasSubstr("/master_seed: is ")) << bad;
  }
}

// Reference  coreutils, for the text that seed.h specifies:
//     printf 'poreclog seed 1\n1\n0\n' | sha256sum | cut -c1-16      and so on.
TEST(Seed, IsTheSpecifiedHash) {
  EXPECT_EQ(realisation_seed("1", 0, ""), 0xf1b7201aeb463b78ULL);
  EXPECT_EQ(realisation_seed("18446744073709551615", 99999, ""), 0xd5b636b7add623ceULL);
  EXPECT_EQ(realisation_seed("1", 0, "abc"), 0xf762f4d94f50601dULL);
}

// Neighbouring master seeds would share members if a seed were master + index.
TEST(Seed, EnsemblesOfNeighbouringMasterSeedsShareNoMember) {
  std::set<std::uint64_t> seeds;
  for (int master = 0; master < 100; ++master) {
    for (int index = 0; index < 1000; ++index) {
      seeds.insert(realisation_seed(std::to_string(master), index, ""));
    }
  }
  EXPECT_EQ(seeds.size(), 100'000U);  // of 2^64: a collision has probability 3e-10
}

Plan small_plan() {
  Plan plan;
  plan.campaign = "c";
  plan.master_seed = "1";
  plan.realisations = 3;
  plan.statistics = json::object();
  for (int i = 0; i < 2; ++i) {
    const json values{{"/d", i}};
    plan.points.push_back({i, sha256(values.dump()), values});
    json scene{{"d", i}, {"e", "5 s"}, {"description", "x"}};
    const std::string hash = hash_of_scene(scene);
    plan.ensembles.push_back({i, "one_way", scene, hash, "one_way", {}});
  }
  return plan;
}

TEST(Plan, ComesBackFromItsFile) {
  const Plan plan = small_plan();
  const json written = to_json(plan);
  EXPECT_EQ(to_json(plan_from_json(written, "f")), written);
  json newer = written;
  newer["format"] = 2;
  EXPECT_THROW(plan_from_json(newer, "f"), InputError);
  newer.erase("format");
  EXPECT_THROW(plan_from_json(newer, "f"), InputError);
}

std::vector<std::string> command_in(const std::string& tier, int ranks,
                                    const std::string& launcher = "") {
  Plan plan = small_plan();
  plan.ensembles[1].tier = "auto";
  plan.ensembles[1].runs_as = tier;
  plan.ranks = ranks;
  plan.limits.seconds_to_stop = 29.5;
  plan.executor = launcher.empty() ? "local" : "slurm";
  plan.slurm.launcher = launcher.empty() ? plan.slurm.launcher : launcher;
  return SolverProgram("/bin/solve").run_command(plan, {1, 0}, "s.json", "r.h5");
}

TEST(SolverProgram, IsThatOfTheTierThatRuns) {
  const std::string seed = std::to_string(realisation_seed("1", 0, ""));
  const auto run = [&](const std::string& program) {
    return std::vector<std::string>{program, "run",    "s.json", "-o",
                                    "r.h5",  "--seed", seed};
  };
  EXPECT_EQ(command_in("quasi_steady", 1), run("/bin/solve"));
  EXPECT_EQ(command_in("transient", 1), run("/bin/solve-transient"));
}

TEST(SolverProgram, StartsRanksThatShareCoresAndHaveTheTimeToStop) {
  const auto mpirun = command_in("transient", 2);
  const std::vector<std::string> begin{
      "mpirun", "-n", "2", "--bind-to", "none", "--mca", "odls_base_sigkill_timeout",
      "30"};
  ASSERT_GT(mpirun.size(), begin.size());
  EXPECT_EQ(std::vector<std::string>(mpirun.begin(), mpirun.begin() + 8), begin);
  EXPECT_EQ(mpirun[mpirun.size() - 7], "/bin/solve-transient");
  const auto srun = command_in("transient", 4, "srun");
  EXPECT_EQ(srun[0], "srun");
  EXPECT_EQ(srun[4], "4");
}

TEST(Changes, OfPhysicsAreListedAndCosmeticOnesAreNot) {
  const Plan before = small_plan();
  Plan after = before;
  after.ensembles[1].scene["description"] = "y";
  after.ensembles[1].scene_hash = hash_of_scene(after.ensembles[1].scene);
  after.limits.workers = 7;
  after.description = "new";
  EXPECT_THAT(forbidden_changes(before, after), ElementsAre());
  for (Ensemble& ensemble : after.ensembles) {
    ensemble.scene["e"] = "6 s";
    ensemble.scene["f"] = 1;
    ensemble.scene_hash = hash_of_scene(ensemble.scene);
  }
  after.master_seed = "2";
  EXPECT_THAT(forbidden_changes(before, after),
              ElementsAre("/master_seed: 1 -> 2", HasSubstr("/e: \"5 s\" -> \"6 s\" ("),
                          HasSubstr("/f: nothing -> 1 (")));
}

TEST(Changes, OfTheOrderOfPointsKeepTheirNumbers) {
  const Plan before = small_plan();
  Plan after = before;
  std::swap(after.points[0], after.points[1]);
  std::swap(after.ensembles[0], after.ensembles[1]);
  std::swap(after.points[0].number, after.points[1].number);
  std::swap(after.ensembles[0].point, after.ensembles[1].point);
  after.realisations = 2;
  EXPECT_THAT(forbidden_changes(before, after), ElementsAre());
  EXPECT_EQ(to_json(continued(before, after)), to_json(before));
}

}  // namespace
}  // namespace colloid
