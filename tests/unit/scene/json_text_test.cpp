#include "scene/json_text.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    parse_json(text, "f.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Locate, FindsMembersAtTheirKeyAndElementsAtTheirValue) {
  const std::string text =
      "{\n"
      "  \"a\": {\"b\\\"c\": 1,\"d\":[10 ,[true], {\n"
      "    \"e/f\": null}, \"x\"]},\n"
      "  \"\xC2\xB5\": 2, \"z\": 3\n"
      "}";
  const std::pair<const char*, const char*> cases[] = {
      {"", "line 1, column 1"},
      {"/a", "line 2, column 3"},
      {"/a/b\"c", "line 2, column 9"},
      {"/a/d", "line 2, column 19"},
      {"/a/d/0", "line 2, column 24"},
      {"/a/d/1", "line 2, column 28"},
      {"/a/d/1/0", "line 2, column 29"},
      {"/a/d/2", "line 2, column 36"},
      {"/a/d/2/e~1f", "line 3, column 5"},
      {"/a/d/3", "line 3, column 19"},
      {"/\xC2\xB5", "line 4, column 3"},
      {"/z", "line 4, column 11"},
  };
  for (const auto& [pointer, place] : cases) {
    EXPECT_EQ(to_string(locate(text, pointer)), place) << pointer;
  }
}

TEST(Locate, FallsBackToTheInnermostValueThatExists) {
  const std::string text = "{\n\"a\": {\n\"b\": [1]}}";
  EXPECT_EQ(locate(text, "/a/missing").line, 2U);
  EXPECT_EQ(locate(text, "/a/b/7").line, 3U);
  EXPECT_EQ(locate(text, "/ab").line, 1U) << "a is no parent of ab";
}

TEST(ParseJson, RefusesAKeyGivenTwiceInOneObjectOnly) {
  EXPECT_NO_THROW(
      parse_json(R"({"a": {"b": 1}, "c": {"b": 1}, "d": [{"b": 1}, {"b": 2}]})", ""));
  EXPECT_THAT(refusal("{\"a\": {\"b\": {\"x\": 1},\n\"b\": 2}}"),
              HasSubstr("f.json line 2, column 1: /a/b: the key is given twice, first on "
                        "line 1"));
  EXPECT_THAT(refusal("{\"a\": 1, \"\\u0061\": 1}"),
              HasSubstr("/a: the key is given twice"));
}

TEST(ParseJson, LimitsTheDepth) {
  const auto nested = [](int depth) {
    const auto n = static_cast<std::size_t>(depth);
    return std::string(n, '[') + std::string(n, ']');
  };
  EXPECT_NO_THROW(parse_json(nested(32), ""));
  EXPECT_THAT(refusal(nested(33)), HasSubstr("column 33: is nested more than 32"));
  EXPECT_THAT(refusal(std::string(10000000, '[')), HasSubstr("is nested more than 32"));
}

TEST(ParseJson, SaysWhyTextIsNotJson) {
  const std::pair<const char*, const char*> cases[] = {
      {"{\"a\": NaN}", "column 7: is not JSON: NaN is not a JSON number"},
      {"{\"a\": -Infinity}", "-Infinity is not a JSON number"},
      {"[1, 2,]", "column 7: is not JSON: a comma before a closing bracket"},
      {"{\"a\": 1,\n}",
       "line 2, column 1: is not JSON: a comma before a closing bracket"},
      {"{'a': 1}", "JSON strings are in double quotes"},
      {"{\"a\": 1 // one\n}", "JSON has no comments"},
      {"{\"a\": True}", "True is Python"},
      {"{\"a\": 1", "the text ends in the middle"},
      {"{\"a\" 1}", "column 6: is not JSON: unexpected number literal; expected ':'"},
      {"{\"a\": 01}", "is not JSON: unexpected number literal"},
      {"{} {}", "column 4: is not JSON: unexpected '{'; expected end of input"},
      {"hello", "column 1: is not JSON: invalid literal"},
      {"{\"a\": \"\n\"}", "is not JSON: invalid string"},
      {"[0, 1e999]", "column 5: /1: the number is beyond the range of a double"},
      {"{\"a\": -1e999}", "/a: the number is beyond the range of a double"},
  };
  for (const auto& [text, why] : cases) {
    EXPECT_THAT(refusal(text), HasSubstr(why)) << text;
    EXPECT_EQ(refusal(text).find('\n'), std::string::npos) << "more than one line";
  }
}

}  // namespace
}  // namespace colloid
