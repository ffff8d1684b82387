// `poreclog-solve run` interrupted, refused and out of room.
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "run_scene.h"

namespace colloid {
namespace {

using testing::HasSubstr;

/// Starts the program and leaves it running.
pid_t start(const std::vector<std::string>& arguments) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> argv;
    std::string program = PORECLOG_SOLVE;
    argv.push_back(program.data());
    std::vector<std::string> copies = arguments;
    for (std::string& argument : copies) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::string reference_result(const std::string& scene) {
  const std::string path = temporary("undisturbed.h5");
  const Outcome outcome = run_program("run " + scene + " -o " + path + " --seed 7");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return path;
}

bool exists(const std::string& path) {
  return access(path.c_str(), F_OK) == 0;
}

void interrupt_often(const std::string& scene_text) {
  const std::string scene = write_temporary("interrupted.json", scene_text);
  const std::string reference = reference_result(scene);
  for (const int signal : {SIGTERM, SIGINT}) {
    const std::string result = temporary("interrupted.h5");
    const std::string checkpoint = temporary("interrupted.checkpoint");
    std::remove(result.c_str());
    int interruptions = 0;
    int code = -1;
    // Later and later, so that it gets to the end however slow the machine is.
    for (int milliseconds = 50; milliseconds < 60000; milliseconds += milliseconds / 2) {
      const pid_t child =
          start({"run", scene, "-o", result, "--seed", "7", "--checkpoint", checkpoint});
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      kill(child, signal);
      code = wait_for(child);
      if (code == 0) {
        break;
      }
      // Before it listens to signals it just dies: nothing is written yet.
      ASSERT_TRUE(code == 5 || code == -signal) << code;
      ASSERT_FALSE(exists(result));
      interruptions += code == 5 ? 1 : 0;
    }
    ASSERT_EQ(code, 0);
    EXPECT_GE(interruptions, 2);
    EXPECT_FALSE(exists(checkpoint)) << "a finished run leaves no checkpoint";
    EXPECT_EQ(run_python("same_datasets.py", reference + " " + result), 0);
  }
}

TEST(InterruptedRun, EndsWithTheSameDatasetsAfterManySignals) {
  interrupt_often(clogging_scene());
}

TEST(InterruptedRun, EndsWithTheSameDatasetsInTheTierQuasiSteady) {
  interrupt_often(in_tier(clogging_scene("0.15 s"), "quasi_steady"));
}

TEST(InterruptedRun, GoesOnFromItsLastIntervalAfterAKill) {
  const std::string scene = write_temporary("killed.json", clogging_scene());
  const std::string reference = reference_result(scene);
  const std::string result = temporary("killed.h5");
  const std::string checkpoint = temporary("killed.checkpoint");
  const pid_t child = start({"run", scene, "-o", result, "--seed", "7", "--checkpoint",
                             checkpoint, "--checkpoint-interval", "0"});
  while (!exists(checkpoint)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  kill(child, SIGKILL);
  EXPECT_EQ(wait_for(child), -SIGKILL);
  EXPECT_FALSE(exists(result));
  const Outcome outcome = run_program("run " + scene + " -o " + result +
                                      " --seed 7 --checkpoint " + checkpoint);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(run_python("same_datasets.py", reference + " " + result), 0);
}

TEST(InterruptedRun, RefusesTheCheckpointOfAnother) {
  const std::string scene = write_temporary("owner.json", clogging_scene());
  const std::string other = write_temporary("other.json", clogging_scene("1.5 s"));
  const std::string result = temporary("owner.h5");
  const std::string checkpoint = temporary("owner.checkpoint");
  const pid_t child = start({"run", scene, "-o", result, "--seed", "7", "--checkpoint",
                             checkpoint, "--checkpoint-interval", "0"});
  while (!exists(checkpoint)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(child, SIGTERM);
  ASSERT_EQ(wait_for(child), 5);
  const std::string tail = " -o " + result + " --checkpoint " + checkpoint;
  const Outcome seed = run_program("run " + scene + tail + " --seed 8");
  EXPECT_EQ(seed.exit_code, 2);
  EXPECT_THAT(seed.err, HasSubstr("seed"));
  const Outcome foreign = run_program("run " + other + tail + " --seed 7");
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_THAT(foreign.err, HasSubstr("scene"));
  const std::string bytes = content(checkpoint);
  const std::string torn =
      write_temporary("torn.checkpoint", bytes.substr(0, bytes.size() / 2));
  const Outcome broken =
      run_program("run " + scene + " -o " + result + " --seed 7 --checkpoint " + torn);
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_FALSE(exists(result));
}

TEST(Run, RefusesWhatItCannotDoBeforeItComputes) {
  const std::string scene = write_temporary("refused.json", clogging_scene());
  struct Case {
    std::string arguments;
    std::string message;
  };
  std::string slow = clogging_scene();
  slow.replace(slow.find("0.5 mm/s"), 8, "50 mm/s ");
  std::string later = clogging_scene();
  later.replace(later.find("one_way"), 7, "transient");
  const std::string here = temporary("refused.h5");
  const std::vector<Case> cases{
      {scene, "--output"},
      {scene + " -o /nowhere/at/all.h5", "/nowhere/at"},
      {scene + " -o " + testing::TempDir(), testing::TempDir()},
      {scene + " -o " + here + " --seed -1", "--seed"},
      {scene + " -o " + here + " --seed 1e3", "--seed"},
      {scene + " -o " + here + " --seed 18446744073709551616", "--seed"},
      {scene + " -o " + here + " --checkpoint-interval -5", "--checkpoint-interval"},
      {write_temporary("inertia.json", slow) + " -o " + here, "Re_throat"},
      {write_temporary("later.json", later) + " -o " + here, "transient"},
      {write_temporary("flow_only.json",
                       R"({"geometry": {"preset": "throat"},
                           "drive": {"inlet_velocity": "1 mm/s"}})") +
           " -o " + here,
       "/colloids"}};
  for (const Case& c : cases) {
    const Outcome outcome = run_program("run " + c.arguments);
    EXPECT_EQ(outcome.exit_code, 2) << c.arguments;
    EXPECT_THAT(outcome.err, HasSubstr(c.message)) << c.arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(exists(here));
  }
}

TEST(Run, LeavesNothingWhereTheDiskIsFull) {
  const std::string scene = write_temporary("full.json", clogging_scene("0.2 s"));
  const std::string result = temporary("full.h5");
  // A limit on the size of files stands for the full disk: 8 blocks of 1024 bytes.
  const std::string command = "sh -c 'ulimit -f 8; exec " PORECLOG_SOLVE " run " + scene +
                              " -o " + result + "' 2>" + temporary("full.err");
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 4);
  EXPECT_THAT(content(temporary("full.err")), HasSubstr(result));
  EXPECT_FALSE(exists(result));
  const std::string left = "ls " + result + "*.part >/dev/null 2>&1";
  EXPECT_NE(std::system(left.c_str()), 0) << "a temporary file was left behind";
}

}  // namespace
}  // namespace colloid
