// Locks, whole files, JSON places, shell words and hashes.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/json_text.h"
#include "base/memory_file.h"
#include "base/subprocess.h"
#include "base/text.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::string temporary(const std::string& name) {
  return testing::TempDir() + "poreclog_" + std::to_string(::getpid()) + "_" + name;
}

std::string refusal(const std::string& text) {
  try {
    parse_json(text, "f.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Reference  FIPS 180-4, examples of NIST: "abc" and the empty message.
TEST(Hash, IsSha256) {
  EXPECT_EQ(sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Json, IsRefusedWithItsPlace) {
  EXPECT_THAT(refusal("{\"a\": 1,\n \"b\": }"),
              HasSubstr("f.json line 2, column 7: is not "));
  EXPECT_THAT(refusal("{\"a\": {\"b\": 1, \"b\": 2}}"),
              HasSubstr("f.json line 1, column 16: /a/b: the key is given twice"));
  EXPECT_THAT(refusal("{\"a\\u0062\": 1,\n\"ab\": 2}"),
              HasSubstr("line 2, column 1: /ab"));
  EXPECT_THAT(refusal(std::string(100, '[') + std::string(100, ']')),
              HasSubstr("nested more than"));
  EXPECT_THAT(refusal("[1e999]"), HasSubstr("range of a double"));
  EXPECT_EQ(refusal(R"({"a": ["}", "\"", {"b/c": [1, 2.5e-3, true, null]}]})"), "");
}

TEST(Json, PlacesArePointersToTheirText) {
  const std::string text = "{\"a\": [10,\n  {\"b/c\": \"x\"}],\n \"d\": 1}";
  EXPECT_EQ(locate(text, "/a/0"), "line 1, column 8");
  EXPECT_EQ(locate(text, "/a/1/b~1c"), "line 2, column 4");
  EXPECT_EQ(locate(text, "/d"), "line 3, column 2");
  EXPECT_EQ(locate(text, "/a/1/nothing"), "line 2, column 3");
  EXPECT_EQ(locate(text, "/nothing"), "line 1, column 1");
}

TEST(Text, QuotedWordsComeBackFromAShell) {
  const std::vector<std::string> words{
      "plain", "", "a b", "it's", "$HOME `x` \"q\" \\", "*", "new\nline", "--x=1"};
  std::vector<std::string> command{
      "/bin/sh", "-c",
      "for w in " + command_line(words) + "; do printf '%s\\0' \"$w\"; done"};
  std::string expected;
  for (const std::string& word : words) {
    expected += word + '\0';
  }
  EXPECT_EQ(run_program(command).out, expected);
}

TEST(Text, NearestIsByEdits) {
  EXPECT_EQ(nearest("realizations", {"ranks", "realisations", "vary"}), "realisations");
  EXPECT_EQ(nearest("tC", {"t1", "tc", "median_s"}), "tc");
  EXPECT_EQ(nearest("C", {"c", "C"}), "C");
}

TEST(Program, ThatIsNotThereIsRefused) {
  EXPECT_THROW(run_program({"/nowhere/program"}), InputError);
  EXPECT_EQ(run_program({"/bin/sh", "-c", "echo out; echo err >&2; exit 3"}).exit_code,
            3);
  EXPECT_EQ(run_program({"/bin/sh", "-c", "kill -9 $$"}).exit_code, 128 + 9);
}

TEST(Lock, IsHeldByOneUntilItGoes) {
  const std::string path = temporary("lock");
  EXPECT_FALSE(FileLock::is_held(path));
  {
    const auto lock = FileLock::take(path, "me\n");
    ASSERT_TRUE(lock.has_value());
    EXPECT_EQ(lock->left_behind(), "");
    EXPECT_TRUE(FileLock::is_held(path));
    EXPECT_FALSE(FileLock::take(path, "other\n").has_value());
    EXPECT_EQ(read_if_there(path), "me\n");
  }
  EXPECT_FALSE(FileLock::is_held(path));
}

TEST(Lock, OfOneThatWasKilledIsFreeAndSaysWhoseItWas) {
  const std::string path = temporary("stale");
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = FileLock::take(path, "child\n");
    ::_exit(0);  // without letting go, as if killed
  }
  ::waitpid(child, nullptr, 0);
  const auto lock = FileLock::take(path, "me\n");
  ASSERT_TRUE(lock.has_value());
  EXPECT_EQ(lock->left_behind(), "child\n");
}

TEST(File, IsWholeOrAbsent) {
  const std::string path = temporary("whole");
  write_whole(path, "one", true);
  write_whole(path, "two", false);
  EXPECT_EQ(read_if_there(path), "two");
  EXPECT_THROW(write_whole("/proc/nowhere", "x", false), StorageError);
  EXPECT_EQ(read_if_there(temporary("absent")), std::nullopt);
}

TEST(File, IsReplacedUnderAReaderThatKeepsTheOldOne) {
  const std::string path = temporary("replaced");
  write_whole(path, "one", false);
  std::ifstream reader(path);
  write_whole(path, "two", false);
  std::string seen;
  reader >> seen;
  EXPECT_EQ(seen, "one");
  EXPECT_EQ(read_if_there(path), "two");
}

TEST(File, InMemoryIsReadByAChildAndHasNoName) {
  const std::string text = "{\"a\": 1}\n" + std::string(200000, 'x');
  std::string path;
  {
    const MemoryFile file(text);
    path = file.path();
    EXPECT_EQ(run_program({"cat", path, path}).out, text + text);
  }
  EXPECT_EQ(read_if_there(path), std::nullopt);
}

}  // namespace
}  // namespace colloid
