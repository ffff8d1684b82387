#include "ingest/attempt_folder.h"

#include <csignal>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/file_lock.h"
#include "base/files.h"

namespace colloid {
namespace {

// The child stands still between the lock and the ending, because the file that it writes
// is a pipe that nobody reads; there it is killed.
TEST(AttemptThatIsGivenUp, IsGivenUpAgainByTheNextIfTheFirstIsKilledMeanwhile) {
  const std::string folder = fmt::format("{}given_up_{}", testing::TempDir(), ::getpid());
  make_folder(folder);
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string part = fmt::format("{}/ending.json.{}.part", folder, ::getpid());
    ::mkfifo(part.c_str(), 0600);
    give_up(folder);
    ::_exit(0);
  }
  while (read_if_there(folder + "/lock").value_or("").empty()) {
    ASSERT_EQ(::waitpid(child, nullptr, WNOHANG), 0) << "it did not stand still";
    ::usleep(1000);
  }
  EXPECT_TRUE(FileLock::is_held(folder + "/lock"));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(is_file(folder + "/ending.json"));
  EXPECT_FALSE(on_another_machine(folder));
  EXPECT_TRUE(give_up(folder));
  EXPECT_EQ(read_attempt(folder, 1).cause, Cause::lost);
}

}  // namespace
}  // namespace colloid
