// Results and checkpoints where they cannot be written: refused at once or reported, and
// never half a file under the final name.
#include <csignal>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include "core/error.h"
#include "io/checkpoint.h"
#include "io/result_file.h"
#include "realisation_example.h"
#include "temporary_folder.h"

namespace colloid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Names = std::set<std::string>;

void start_result(const std::string& path) {
  const ResultFile file(path, collect_provenance({"test"}), throat_scene());
}

void write_result(const std::string& path, const Realisation& realisation) {
  ResultFile(path, collect_provenance({"test"}), throat_scene()).finish(realisation);
}

std::string refusal(const std::string& path) {
  return message_of<InputError>([&] { start_result(path); });
}

/// While it lives, no file of this process may become larger than `bytes`.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit limited{bytes, before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

/// While it lives, root is nobody, for whom permissions count.
class Unprivileged {
 public:
  Unprivileged() : before_(::geteuid()) {
    if (before_ == 0) {
      EXPECT_EQ(::seteuid(65534), 0);
    }
  }
  ~Unprivileged() {
    if (before_ == 0) {
      EXPECT_EQ(::seteuid(before_), 0);
    }
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  uid_t before_;
};

TEST(UnwritableResult, FolderIsMissing) {
  const TemporaryFolder folder;
  const std::string path = folder.file("no/such/r.h5");
  EXPECT_EQ(refusal(path),
            path + ": cannot be written: there is no folder " + folder.file("no/such"));
}

TEST(UnwritableResult, FolderIsAFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("file"), "x");
  EXPECT_THAT(refusal(folder.file("file/r.h5")), HasSubstr("there is no folder"));
}

TEST(UnwritableResult, NameIsThatOfAFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path()),
              AllOf(HasSubstr(folder.path()), HasSubstr("is a folder")));
}

TEST(UnwritableResult, NameIsEmpty) {
  EXPECT_THAT(refusal(""), HasSubstr("empty name"));
}

TEST(UnwritableResult, NameIsTooLong) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.file(std::string(250, 'r'))),
              HasSubstr("File name too long"));
}

TEST(UnwritableResult, FolderIsReadOnly) {
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  const Unprivileged nobody;
  EXPECT_THAT(refusal(folder.file("r.h5")),
              AllOf(HasSubstr(folder.file("r.h5")), HasSubstr("refuses new files"),
                    HasSubstr("Permission denied")));
}

// A limit on the size of files stands for any disk that takes no more: the write fails
// after some bytes, wherever that is.
TEST(FullDisk, LeavesNothingBehindWhereverItStrikes) {
  const TemporaryFolder folder;
  const std::string path = folder.file("r.h5");
  write_result(path, example_realisation());
  const std::size_t size = bytes_of(path).size();
  ASSERT_EQ(std::remove(path.c_str()), 0);
  int failures = 0;
  for (std::size_t limit = 0; limit < size; limit += size / 17) {
    std::string message;
    {
      const FileSizeLimit full(limit);
      message =
          message_of<OutputError>([&] { write_result(path, example_realisation()); });
    }
    EXPECT_EQ(message, path + ": cannot be written: File too large") << limit;
    EXPECT_EQ(folder.names(), Names{}) << limit;
    ++failures;
  }
  EXPECT_GE(failures, 17);
  const FileSizeLimit enough(size);
  write_result(path, example_realisation());
  EXPECT_EQ(folder.names(), Names{"r.h5"});
}

TEST(FullDisk, SparesTheCheckpointThatIsThere) {
  const TemporaryFolder folder;
  const Checkpoint old = example_checkpoint();
  write_checkpoint(folder.file("c"), old);
  {
    const FileSizeLimit full(5000);
    EXPECT_THAT(message_of<OutputError>(
                    [&] { write_checkpoint(folder.file("c"), example_checkpoint(60)); }),
                HasSubstr(folder.file("c")));
  }
  EXPECT_EQ(folder.names(), Names{"c"});
  EXPECT_EQ(bits_of(read_checkpoint(folder.file("c"), old.identity)), bits_of(old));
}

// The real thing, where this user may mount one.
TEST(FullDisk, OfATinyFileSystemIsReported) {
  const TemporaryFolder folder;
  if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "may not mount a file system here";
  }
  const std::string path = folder.file("r.h5");
  EXPECT_EQ(
      message_of<OutputError>([&] { write_result(path, example_realisation(400)); }),
      path + ": cannot be written: No space left on device");
  EXPECT_EQ(folder.names(), Names{});
  EXPECT_EQ(::umount(folder.path().c_str()), 0);
}

TEST(VanishedFolder, IsReportedAtTheEnd) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("runs"));
  ResultFile file(folder.file("runs/r.h5"), collect_provenance({"test"}), throat_scene());
  std::filesystem::remove_all(folder.file("runs"));
  EXPECT_EQ(message_of<OutputError>([&] { file.finish(example_realisation()); }),
            folder.file("runs/r.h5") +
                ": cannot be put in its place: No such file or "
                "directory");
}

}  // namespace
}  // namespace colloid
