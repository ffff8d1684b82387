// Bad scenes through the real program: exit code 2, nothing on standard output, one line
// on standard error that names file, line and pointer and says what was expected.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "bad_scenes.h"

namespace colloid {
namespace {

using testing::HasSubstr;

struct Outcome {
  int exit_code;
  std::string out;
  std::string err;
};

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string temporary(const std::string& name) {
  return testing::TempDir() + "anomaly_scene_" + std::to_string(getpid()) + name;
}

Outcome run(const std::string& arguments) {
  const std::string out = temporary(".out");
  const std::string err = temporary(".err");
  const std::string command =
      std::string(PORECLOG_SOLVE) + " " + arguments + " >" + out + " 2>" + err;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
}

Outcome run_scene(const std::string& text) {
  const std::string path = temporary(".json");
  std::ofstream(path, std::ios::binary) << text;
  return run("describe --scene " + path);
}

void expect_refused(const Outcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.exit_code, 2) << what << outcome.err;
  EXPECT_EQ(outcome.out, "") << what;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1)
      << what << outcome.err;
}

void expect_all_refused(const std::vector<BadScene>& scenes) {
  for (const BadScene& scene : scenes) {
    const Outcome outcome = run_scene(scene.text);
    const std::string what = scene.text.substr(0, 300) + "\n";
    expect_refused(outcome, what);
    EXPECT_THAT(outcome.err, HasSubstr(".json line " + std::to_string(scene.line) + ", "))
        << what;
    if (!scene.pointer.empty()) {
      EXPECT_THAT(outcome.err, HasSubstr(": " + scene.pointer + ": ")) << what;
    }
    EXPECT_THAT(outcome.err, HasSubstr(scene.expected)) << what;
  }
}

TEST(BadScene, IsRefusedForItsKeysAndValues) {
  expect_all_refused(bad_keys_and_values());
}

TEST(BadScene, IsRefusedForContradictions) {
  expect_all_refused(bad_combinations());
}

TEST(BadScene, IsRefusedForItsText) {
  expect_all_refused(bad_texts());
}

// Tests the test: what all bad scenes are made from is accepted.
TEST(BadScene, DiffersFromAGoodOneOnlyInWhatIsBad) {
  for (const std::string& text :
       {throat_with(R"("duration": "5 s")"), box_with("wwwwww"), box_with("ppppss"),
        box_with("wwwwoi", "", R"("drive": {"pressure_drop": "1 Pa"})")}) {
    const Outcome outcome = run_scene(text);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out, "");
  }
}

TEST(BadFile, IsRefusedByName) {
  const std::pair<std::string, const char*> cases[] = {
      {"/nowhere/scene.json", "/nowhere/scene.json: cannot be opened: No such file"},
      {testing::TempDir(), "is a folder, expected a file"},
      {"/dev/null", "/dev/null: is empty"},
      {"/dev/zero", "/dev/zero: is larger than 256 MiB"},
      {"''", "No such file"},
  };
  for (const auto& [path, why] : cases) {
    const Outcome outcome = run("describe --scene " + path);
    expect_refused(outcome, path);
    EXPECT_THAT(outcome.err, HasSubstr(why)) << path;
  }
}

TEST(BadFile, OfSpheresIsRefusedByItsOwnLine) {
  std::ofstream(temporary(".csv"))
      << "x_m,y_m,z_m,diameter_m\n5e-6,5e-6,5e-6,1e-6\n5,x,5,1\n";
  const std::string name = temporary(".csv").substr(testing::TempDir().size());
  const Outcome outcome =
      run_scene(box_with("wwwwww", "\"spheres_file\": \"" + name + "\""));
  expect_refused(outcome, name);
  EXPECT_THAT(outcome.err, HasSubstr(name + " line 3: y_m is \"x\", expected a finite "));
}

TEST(BadCommandLine, IsRefused) {
  for (const char* arguments :
       {"", "descibe", "describe --jsn", "describe --scene", "describe extra"}) {
    const Outcome outcome = run(arguments);
    expect_refused(outcome, arguments);
    EXPECT_THAT(outcome.err, HasSubstr("command line: ")) << arguments;
  }
}

TEST(GoodCommandLine, AnswersHelpAndVersion) {
  EXPECT_EQ(run("--help").exit_code, 0);
  const Outcome version = run("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, HasSubstr("poreclog "));
  EXPECT_THAT(version.out, HasSubstr("commit "));
}

}  // namespace
}  // namespace colloid
