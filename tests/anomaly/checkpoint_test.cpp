// Checkpoints that must not be continued from: damaged ones, and those of another run.
#include "io/checkpoint.h"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "io/result_file.h"
#include "realisation_example.h"
#include "temporary_folder.h"

namespace colloid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder with a checkpoint c.
class BadCheckpoint : public testing::Test {
 protected:
  BadCheckpoint() { write_checkpoint(path_, checkpoint_); }

  /// What reading `bytes` is refused with.
  std::string refusal(const std::string& bytes) const {
    write_bytes(path_, bytes);
    return refusal_of(path_, checkpoint_.identity);
  }

  static std::string refusal_of(const std::string& path, const RunIdentity& expected) {
    return message_of<InputError>([&] { read_checkpoint(path, expected); });
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("c");
  const Checkpoint checkpoint_ = example_checkpoint();
};

TEST_F(BadCheckpoint, IsMissing) {
  EXPECT_EQ(refusal_of(folder_.file("none"), checkpoint_.identity),
            folder_.file("none") + ": there is no such checkpoint");
}

TEST_F(BadCheckpoint, IsAFolder) {
  EXPECT_THAT(refusal_of(folder_.path(), checkpoint_.identity), HasSubstr("is a folder"));
}

TEST_F(BadCheckpoint, IsSomethingElse) {
  EXPECT_EQ(refusal("a text about something else"),
            path_ + ": is not a checkpoint of poreclog");
  ResultFile(path_, collect_provenance({"test"}), throat_scene())
      .finish(example_realisation());
  EXPECT_EQ(refusal_of(path_, checkpoint_.identity),
            path_ + ": is not a checkpoint of poreclog");
}

TEST_F(BadCheckpoint, IsTooLong) {
  EXPECT_THAT(refusal(bytes_of(path_) + '\0'), HasSubstr("damaged"));
}

// Every length within the header, every 37th beyond, and one byte less.
TEST_F(BadCheckpoint, IsCutShortAnywhere) {
  const std::size_t whole = bytes_of(path_).size();
  ASSERT_GT(whole, 10000U);
  for (std::size_t length = whole - 1;; length -= length > 600 ? 37 : 1) {
    ASSERT_EQ(::truncate(path_.c_str(), static_cast<off_t>(length)), 0);
    EXPECT_THAT(refusal_of(path_, checkpoint_.identity),
                AllOf(StartsWith(path_ + ": is "),
                      HasSubstr(length <= 512 ? "cut short" : "damaged")))
        << "at " << length;
    if (length == 0) {
      break;
    }
  }
}

// One bit anywhere: each one of the header, and one of every 23rd byte of the rest.
TEST_F(BadCheckpoint, HasOneBitFlippedAnywhere) {
  const std::string whole = bytes_of(path_);
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  const auto put = [&](std::size_t at, char byte) {
    file.seekp(static_cast<std::streamoff>(at)).put(byte).flush();
  };
  int flipped = 0;
  for (std::size_t bit = 0; bit < 8 * whole.size();
       bit += bit < 8 * 512 ? 1 : 23 * 8 + 3) {
    const char byte = whole[bit / 8];
    put(bit / 8, static_cast<char>(byte ^ (1 << (bit % 8))));
    EXPECT_THAT(refusal_of(path_, checkpoint_.identity), StartsWith(path_ + ": is "))
        << "bit " << bit;
    put(bit / 8, byte);
    ++flipped;
  }
  EXPECT_GT(flipped, 4096 + 500);
  EXPECT_EQ(bits_of(read_checkpoint(path_, checkpoint_.identity)), bits_of(checkpoint_));
}

TEST_F(BadCheckpoint, IsOfAnotherFormat) {
  std::string other = bytes_of(path_);
  const std::size_t at = other.find("format 1");
  ASSERT_NE(at, std::string::npos);
  other[at + 7] = '2';
  EXPECT_EQ(refusal(other), path_ + ": is a checkpoint of format 2, expected 1");
}

TEST_F(BadCheckpoint, IsOfAnotherRun) {
  const RunIdentity& mine = checkpoint_.identity;
  Scene scene = throat_scene();
  scene.fluid.viscosity *= 2.0;
  RunIdentity other = run_identity(scene, mine.seed, mine.tier);
  EXPECT_EQ(refusal_of(path_, other),
            path_ + ": is a checkpoint of another scene (SHA-256): " + mine.scene_hash +
                ", expected " + other.scene_hash);
  other = mine;
  other.seed = 3;
  EXPECT_EQ(
      refusal_of(path_, other),
      path_ + ": is a checkpoint of another seed: 18364758544493064720, expected 3");
  other = mine;
  other.tier = "quasi_steady";
  EXPECT_EQ(refusal_of(path_, other),
            path_ + ": is a checkpoint of another tier: one_way, expected quasi_steady");
  other = mine;
  other.version = "99.0";
  EXPECT_EQ(refusal_of(path_, other),
            path_ + ": is a checkpoint of another program version: " + mine.version +
                ", expected 99.0");
  other = mine;
  other.commit = "abc";
  EXPECT_EQ(refusal_of(path_, other),
            path_ + ": is a checkpoint of another program build (commit): " +
                mine.commit + ", expected abc");
}

// A program killed after any number of bytes leaves the checkpoint before.  The kernel
// kills at the limit on the size of files: at that byte, every time.
TEST_F(BadCheckpoint, IsNotLeftByAKillWhileWriting) {
  const std::size_t size = bytes_of(path_).size();
  for (std::size_t limit = 0; limit < size; limit += size / 11) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      std::signal(SIGXFSZ, SIG_DFL);
      const rlimit no_core{0, 0};
      const rlimit killed{limit, limit};
      ::setrlimit(RLIMIT_CORE, &no_core);
      ::setrlimit(RLIMIT_FSIZE, &killed);
      try {
        write_checkpoint(path_, example_checkpoint(40));
      } catch (...) {
        ::_exit(1);
      }
      ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) << limit;
    EXPECT_EQ(bits_of(read_checkpoint(path_, checkpoint_.identity)),
              bits_of(checkpoint_));
  }
}

}  // namespace
}  // namespace colloid
