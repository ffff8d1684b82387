// `poreclog-solve describe --injections` with seeds that are none and scenes into which
// nothing can be injected: exit code 2, one line, nothing on standard output.
#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bad_scenes.h"
#include "program.h"

namespace colloid {
namespace {

using testing::HasSubstr;

const std::string kThroat = PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json";

void expect_refused(const std::string& arguments, const std::string& message) {
  const Outcome outcome = run_program("describe " + arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments << '\n' << outcome.err;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1)
      << arguments << '\n'
      << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
}

void expect_scene_refused(const std::string& text, const std::string& message) {
  const std::string path = write_temporary("scene.json", text);
  expect_refused("--injections " + path + " --seed 1 --json", message);
}

TEST(BadSeed, IsRefused) {
  for (const char* seed : {"-1", "-0", "+1", "1.0", "1e3", "0x10", "''", "' 1'", "'1 '",
                           "18446744073709551616", "1000000000000000000000000000000",
                           "seed", "1,2", "nan", "\"$(printf '1\\n2')\""}) {
    expect_refused("--injections " + kThroat + " --seed " + seed,
                   "expected a whole number from 0 to 18446744073709551615");
    expect_refused("--injections " + kThroat + " --seed=" + seed, "--seed");
  }
  expect_refused("--injections " + kThroat + " --seed", "--seed");
  expect_refused("--injections " + kThroat + " --seed 1 --seed 2", "--seed");
}

TEST(BadSeed, IsMissingOrUnwanted) {
  expect_refused("--injections " + kThroat, "--seed: is missing");
  expect_refused("--seed 1", "--seed: goes with --injections SCENE only");
  expect_refused("--seed 1 --regime " + kThroat, "--seed: goes with --injections");
  expect_refused("--injections " + kThroat + " --seed 1 --regime " + kThroat,
                 "Requires at most 1 options");
}

TEST(BadInjections, AreRefusedWithLineAndPointer) {
  expect_refused("--injections /nowhere.json --seed 1", "/nowhere.json");
  expect_scene_refused(throat_with(R"("walls": "inert")"),
                       "/colloids: is missing: without colloids nothing is injected");
  const std::string colloids = R"("colloids": {"diameter": "1 um"})";
  expect_scene_refused(box_with("ppppww", "", colloids + R"(, "drive": {"body_force":
                       ["1 N/m^3", "0 N/m^3", "0 N/m^3"]})"),
                       "line 3, column 2: /geometry/faces: has no inlet");
  // Fits, but not with a capture gap of 13 nm to both walls.
  expect_scene_refused(box_with("wwwwoi", "", R"("colloids": {"diameter": "9.99 um"},
                       "drive": {"inlet_velocity": "0.5 mm/s"})"),
                       "line 5, column 15: /colloids/diameter: is 9.99e-06 m");
  expect_scene_refused(box_with("wwwwoi", R"("spheres": [{"center":
                       ["5 um", "5 um", "4 um"], "diameter": "15 um"}])",
                                colloids + R"(, "drive": {"pressure_drop": "1 Pa"})"),
                       "/drive: moves no liquid through the inlet");
}

TEST(BadInjections, AreRefusedWhereColloidsFindNoPlace) {
  const std::string drive = R"("drive": {"inlet_velocity": "0.5 mm/s"}, )";
  // A grain that just does not reach the inlet.
  expect_scene_refused(
      box_with("ppppoi", R"("spheres": [{"center": ["5 um", "5 um", "5.9 um"],
               "diameter": "8 um"}])",
               drive + R"("colloids": {"diameter": "9 um"})"),
      "/geometry: leaves a colloid no place at the inlet");
  // Spheres placed at random, one after the other, jam at a volume fraction of 0.38.
  expect_scene_refused(
      throat_with(R"("colloids": {"diameter": "13.3 um", "volume_fraction": 0.5})"),
      "line 4, column 38: /colloids/volume_fraction: is 0.5: the inlet is too crowded");
  expect_scene_refused(
      throat_with(R"("colloids": {"diameter": "13.3 um"}, "duration": "1e6 s")"),
      "line 4, column 39: /duration: is 1e+06 s, in which 1.89e+07 colloids enter");
}

}  // namespace
}  // namespace colloid
