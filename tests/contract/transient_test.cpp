// What scripts of users rely on in `poreclog-solve-transient` before a run begins, which
// is what they rely on in poreclog-solve; alone and on two ranks (PORECLOG_SOLVE brings
// mpirun).
#include <algorithm>

#include <gmock/gmock.h>

#include "run_scene.h"

namespace colloid {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

bool exists(const std::string& path) {
  return access(path.c_str(), F_OK) == 0;
}

/// Refused, in one line that holds `message`, with nothing on stdout.
void expect_refused(const std::string& arguments, const std::string& message) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_THAT(outcome.err, StartsWith("poreclog-solve-transient: ")) << arguments;
  EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(Transient, PrintsItsVersionAndHelpOnce) {
  const Outcome version = run_program("--version");
  EXPECT_EQ(version.exit_code, 0) << version.err;
  EXPECT_THAT(version.out, StartsWith("poreclog "));
  EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '\n'), 1) << version.out;
  EXPECT_EQ(version.err, "");
  const Outcome help = run_program("run --help");
  EXPECT_EQ(help.exit_code, 0) << help.err;
  for (const char* option : {"scene", "--output", "--seed", "--checkpoint",
                             "--checkpoint-interval", "--progress", "--json"}) {
    EXPECT_THAT(help.out, HasSubstr(option));
  }
  EXPECT_EQ(help.err, "");
}

TEST(Transient, RefusesCommandLinesWithExitCode2) {
  const std::string scene =
      write_temporary("refused.json", in_tier(clogging_scene(), "transient"));
  const std::string here = " -o " + temporary("refused.h5");
  expect_refused("", "subcommand");
  expect_refused("run " + scene, "--output");
  expect_refused("run " + scene + here + " --seed -1", "--seed");
  expect_refused("run /nowhere.json" + here, "/nowhere.json");
  EXPECT_FALSE(exists(temporary("refused.h5")));
}

TEST(Transient, RefusesScenesWithExitCode2) {
  const std::string good = in_tier(clogging_scene(), "transient");
  const auto refused = [&](const std::string& old, const std::string& by,
                           const std::string& message) {
    std::string text = good;
    text.replace(text.find(old), old.size(), by);
    expect_refused(
        "run " + write_temporary("bad.json", text) + " -o " + temporary("bad.h5"),
        message);
  };
  refused("\"drive\"", "\"drvie\"", "the nearest is \"drive\"");
  refused("\"20 um\"", "\"20 kg\"", "/colloids/diameter");
  refused("\"hindrance\": \"wall\"", "\"wall_refinement\": 2",
          "/fidelity/wall_refinement");
  refused("\"hindrance\": \"wall\"", "\"dem_step\": 5e-8", "/fidelity/dem_step");
  refused("\"hindrance\": \"wall\"", "\"coupling\": \"loose\"", "/fidelity/coupling");
}

TEST(Transient, RefusesTheTiersOfTheOtherProgram) {
  for (const std::string tier : {"one_way", "quasi_steady"}) {
    const std::string scene =
        write_temporary("other.json", in_tier(clogging_scene(), tier));
    expect_refused("run " + scene + " -o " + temporary("other.h5"),
                   "/fidelity/tier: is " + tier + "; run it with poreclog-solve: ");
  }
  const std::string scene =
      write_temporary("auto.json", in_tier(clogging_scene(), "auto"));
  expect_refused("run " + scene + " -o " + temporary("other.h5"),
                 "is auto, which means one_way here (the cheapest that is valid); "
                 "run it with poreclog-solve: ");
}

TEST(Transient, SaysWhatItCostsWhereItIsNotNeeded) {
  const std::string scene =
      write_temporary("slow.json", in_tier(clogging_scene(), "transient"));
  const Outcome outcome = run_program("run " + scene + " -o /nowhere/at/all.h5");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("does not need the tier transient (Re_throat = "));
  EXPECT_THAT(outcome.err, HasSubstr("one_way is the cheapest that is valid; about "));
  EXPECT_THAT(outcome.err, HasSubstr(" core-hours\n"));
  EXPECT_THAT(outcome.err, HasSubstr("/nowhere/at"));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
}

}  // namespace
}  // namespace colloid
