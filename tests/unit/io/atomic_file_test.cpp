#include "io/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "temporary_folder.h"

namespace colloid {
namespace {

using Names = std::set<std::string>;

TEST(AtomicFile, AppearsAtCommitAndNotBefore) {
  const TemporaryFolder folder;
  AtomicFile file(folder.file("a"));
  file.write("a first version that is longer");
  file.write("the content");
  EXPECT_EQ(folder.names().count("a"), 0U);
  EXPECT_EQ(bytes_of(file.part_path()), "the content");
  file.commit();
  EXPECT_EQ(folder.names(), Names{"a"});
  EXPECT_EQ(bytes_of(folder.file("a")), "the content");
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  { AtomicFile(folder.file("a")).write("x"); }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(AtomicFile, KeepsTheOldFileUntilCommit) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  AtomicFile file(folder.file("a"));
  file.write("new");
  EXPECT_EQ(bytes_of(folder.file("a")), "old");
  file.commit();
  EXPECT_EQ(bytes_of(folder.file("a")), "new");
}

TEST(AtomicFile, TwoWritersOfOneNameDoNotMix) {
  const TemporaryFolder folder;
  AtomicFile one(folder.file("a"));
  AtomicFile two(folder.file("a"));
  EXPECT_NE(one.part_path(), two.part_path());
  one.write("one");
  two.write("second");
  one.commit();
  EXPECT_EQ(bytes_of(folder.file("a")), "one");
  two.commit();
  EXPECT_EQ(bytes_of(folder.file("a")), "second");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(AtomicFile, HasThePermissionsOfAnyOtherFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("plain"), "");
  AtomicFile file(folder.file("a"));
  file.commit();
  struct stat plain {};
  struct stat atomic {};
  ASSERT_EQ(::stat(folder.file("plain").c_str(), &plain), 0);
  ASSERT_EQ(::stat(folder.file("a").c_str(), &atomic), 0);
  EXPECT_EQ(atomic.st_mode, plain.st_mode);
}

}  // namespace
}  // namespace colloid
