#include "core/text_file.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::string write_file(const std::string& content) {
  const std::string path = testing::TempDir() + "text_file_test.txt";
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

std::string refusal(const std::string& path) {
  try {
    read_text_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TextFile, IsReadWholeWithoutItsByteOrderMark) {
  const std::string large(200000, 'x');
  EXPECT_EQ(read_text_file(write_file(large)), large);
  EXPECT_EQ(read_text_file(write_file("\xEF\xBB\xBF{}")), "{}");
  EXPECT_EQ(read_text_file(write_file("\xC2\xB5 \xE2\x84\xAB \xF0\x9F\x92\xA7")),
            "\xC2\xB5 \xE2\x84\xAB \xF0\x9F\x92\xA7");
}

TEST(TextFile, RefusesWhatIsNoTextFile) {
  EXPECT_THAT(refusal("/nowhere/scene.json"), HasSubstr("No such file"));
  EXPECT_THAT(refusal(""), HasSubstr("No such file"));
  EXPECT_THAT(refusal(testing::TempDir()), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(write_file("")), HasSubstr("is empty"));
  EXPECT_THAT(refusal(write_file(" \n\t ")), HasSubstr("is empty"));
}

// Each is one of the forms that RFC 3629 forbids.
TEST(TextFile, RefusesBytesThatAreNotUtf8AndSaysWhere) {
  for (const char* bad :
       {"\xFF", "\xB5m", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
        "\xF8\x88\x80\x80\x80", "\xC2", "\xE2\x84"}) {
    const std::string message = refusal(write_file(std::string("a\n\xC2\xB5z") + bad));
    EXPECT_THAT(message, HasSubstr("line 2, column 3: is not UTF-8")) << message;
  }
}

TEST(TextPosition, CountsLinesAndCharactersFromOne) {
  const std::string text = "ab\n\xC2\xB5z\n";
  EXPECT_EQ(to_string(position_of(text, 0)), "line 1, column 1");
  EXPECT_EQ(to_string(position_of(text, 2)), "line 1, column 3");
  EXPECT_EQ(to_string(position_of(text, 5)), "line 2, column 2");
  EXPECT_EQ(to_string(position_of(text, 99)), "line 3, column 1");
}

}  // namespace
}  // namespace colloid
