// The pool of keepers on this machine, with the real poreclog-attempt.
#include "execute/local_executor.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "base/error.h"
#include "base/files.h"
#include "base/signals.h"
#include "temporary_folder.h"

namespace colloid {
namespace {

class LocalExecutorTest : public testing::Test {
 protected:
  Job job(std::int64_t id, const std::string& name, const std::string& script) {
    Job job;
    job.id = id;
    job.folder = folder_.file("000000/" + name);
    job.command = {"/bin/sh", "-c", script};
    job.command_line = "sh -c '" + script + "'";
    job.seconds = 60.0;
    job.seconds_to_stop = 1.0;
    return job;
  }

  /// Ids of the jobs that end, until `count` have; the signals wake us, or it fails.
  std::vector<std::int64_t> wait_for(LocalExecutor& executor, std::size_t count) {
    std::vector<std::int64_t> ended;
    while (ended.size() < count) {
      if (signals_.wait(20.0) == Signals::Event::none) {
        ADD_FAILURE() << "nothing ended";
        break;
      }
      for (const std::int64_t id : executor.poll()) {
        ended.push_back(id);
      }
    }
    return ended;
  }

  std::string text(const std::string& name) {
    return read_if_there(folder_.file("000000/" + name)).value_or("none");
  }

  Signals signals_;
  TemporaryFolder folder_;
};

TEST_F(LocalExecutorTest, KeepsOneAttemptAfterAnotherByTheSameProcess) {
  LocalExecutor executor(1, PORECLOG_ATTEMPT);
  executor.submit({job(1, "attempt-001", "echo one; exit 3")});
  EXPECT_EQ(executor.free_slots(), 0U);
  EXPECT_EQ(wait_for(executor, 1), (std::vector<std::int64_t>{1}));
  executor.submit({job(2, "attempt-002", "echo two >&2; pwd")});
  EXPECT_EQ(wait_for(executor, 1), (std::vector<std::int64_t>{2}));
  EXPECT_EQ(executor.free_slots(), 1U);
  EXPECT_EQ(text("attempt-001/command"), "sh -c 'echo one; exit 3'\n");
  EXPECT_EQ(text("attempt-001/stdout"), "one\n");
  EXPECT_EQ(text("attempt-002/stdout"), folder_.file("000000/attempt-002") + "\n");
  EXPECT_EQ(text("attempt-002/stderr"), "two\n");
  EXPECT_NE(text("attempt-001/ending.json").find("\"exit_code\": 3"), std::string::npos);
  EXPECT_NE(text("attempt-002/ending.json").find("\"exit_code\": 0"), std::string::npos);
  EXPECT_EQ(text("attempt-001/lock"), text("attempt-002/lock"));
  EXPECT_FALSE(is_running(folder_.file("000000/attempt-002")));
}

TEST_F(LocalExecutorTest, HandsTheSolverNothingOfItsOwn) {
  // What the solver has open besides what we were started with, and what it does about
  // SIGPIPE and blocked signals.
  std::string ours;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    ours += std::filesystem::read_symlink(entry.path(), gone).string() + "\n";
  }
  LocalExecutor executor(1, PORECLOG_ATTEMPT);
  executor.submit({job(1, "attempt-001",
                       "for f in /proc/self/fd/*; do readlink $f; done;"
                       "grep -E 'SigBlk|SigIgn' /proc/self/status")});
  wait_for(executor, 1);
  const std::string seen = text("attempt-001/stdout");
  std::istringstream lines(seen);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("pipe:", 0) == 0) {
      EXPECT_NE(ours.find(line), std::string::npos) << seen;
    }
  }
  EXPECT_NE(seen.find("SigBlk:\t0000000000000000"), std::string::npos) << seen;
  EXPECT_NE(seen.find("SigIgn:\t0000000000000000"), std::string::npos) << seen;
}

TEST_F(LocalExecutorTest, BeginsNoAttemptWhoseFolderIsThereAndSaysSoOnce) {
  LocalExecutor executor(2, PORECLOG_ATTEMPT);
  ASSERT_EQ(::mkdir(folder_.file("000000").c_str(), 0755), 0);
  ASSERT_EQ(::mkdir(folder_.file("000000/attempt-001").c_str(), 0755), 0);
  executor.submit({job(1, "attempt-001", "echo never")});
  std::string told;
  while (told.empty() && signals_.wait(20.0) == Signals::Event::child) {
    try {
      executor.poll();
    } catch (const StorageError& error) {
      told = error.what();
    }
  }
  EXPECT_NE(told.find("attempt-001: the folder cannot be made: File exists"),
            std::string::npos)
      << told;
  EXPECT_EQ(executor.poll(), (std::vector<std::int64_t>{1}));  // it can be done with
  EXPECT_EQ(text("attempt-001/stdout"), "none");
}

TEST_F(LocalExecutorTest, GoesOnAfterAnIdleKeeperWasKilled) {
  LocalExecutor executor(1, PORECLOG_ATTEMPT);
  executor.submit({job(1, "attempt-001", "exit 0")});
  wait_for(executor, 1);
  const pid_t keeper = keeper_of(folder_.file("000000/attempt-001")).process;
  ASSERT_GT(keeper, 1);
  ASSERT_EQ(::kill(keeper, SIGKILL), 0);
  siginfo_t ended{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(keeper), &ended, WEXITED | WNOWAIT), 0);
  executor.submit({job(2, "attempt-002", "echo alive")});
  wait_for(executor, 1);
  EXPECT_EQ(text("attempt-002/stdout"), "alive\n");
}

TEST_F(LocalExecutorTest, ReportsTheAttemptOfAKilledKeeperWithoutAnEnding) {
  LocalExecutor executor(1, PORECLOG_ATTEMPT);
  executor.submit({job(1, "attempt-001", "touch begun; exec sleep 60")});
  const std::string folder = folder_.file("000000/attempt-001");
  while (!is_file(folder + "/begun")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_EQ(::kill(keeper_of(folder).process, SIGKILL), 0);
  std::vector<std::int64_t> ended;
  for (int i = 0; i < 1000 && ended.empty(); ++i) {  // the lock goes an instant later
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ended = executor.poll();
  }
  EXPECT_EQ(ended, (std::vector<std::int64_t>{1}));
  EXPECT_EQ(text("attempt-001/ending.json"), "none");
  EXPECT_EQ(executor.free_slots(), 1U);
}

TEST_F(LocalExecutorTest, StopsOneThatIsAskedBeforeItsSolverHasBegun) {
  LocalExecutor executor(1, PORECLOG_ATTEMPT);
  executor.submit({job(1, "attempt-001", "sleep 60")});
  executor.cancel(Stop::politely);  // most likely before the keeper is ready
  wait_for(executor, 1);
  EXPECT_NE(text("attempt-001/ending.json").find("\"stopped\": \"asked\""),
            std::string::npos)
      << text("attempt-001/ending.json");
}

}  // namespace
}  // namespace colloid
