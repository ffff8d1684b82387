// How runs of several ranks end: tiers/transient/runtime.h.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace colloid {
namespace {

struct Outcome {
  int exit_code;
  std::string err;
};

Outcome two_ranks(const std::string& arguments) {
  const std::string err =
      testing::TempDir() + "poreclog_ranks_" + std::to_string(getpid());
  const std::string command = "timeout 60 " TWO_RANKS " " + arguments + " 2>" + err;
  const int status = std::system(command.c_str());
  std::ostringstream text;
  text << std::ifstream(err).rdbuf();
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text.str()};
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Runtime, EndsAllRanksWithOneCodeAndOneComplaint) {
  const Outcome both = two_ranks("both 3 after");
  EXPECT_EQ(both.exit_code, 3);
  EXPECT_EQ(both.err, "something is wrong\n");
  EXPECT_EQ(two_ranks("none 0 after").exit_code, 0);
}

TEST(Runtime, NamesTheRankThatFailedWhereTheFirstDidNot) {
  const Outcome second = two_ranks("1 4 after");
  EXPECT_EQ(second.exit_code, 4);
  EXPECT_EQ(second.err, "rank 1: something is wrong\n");
}

// Whoever waits for a rank that has failed would wait for ever.
TEST(Runtime, EndsRanksThatWaitForOneThatFailed) {
  for (const std::string rank : {"0", "1"}) {
    const Outcome alone = two_ranks(rank + " 3 alone");
    EXPECT_EQ(alone.exit_code, 3);
    EXPECT_EQ(count(alone.err, "something is wrong\n"), 1) << alone.err;
  }
}

}  // namespace
}  // namespace colloid
