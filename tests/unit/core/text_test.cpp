#include "core/text.h"

#include <gtest/gtest.h>

namespace colloid {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("viscosity", "viscosity"), 0);
  EXPECT_EQ(edit_distance("viscocity", "viscosity"), 1);
  EXPECT_EQ(edit_distance("viscosit", "viscosity"), 1);
  EXPECT_EQ(edit_distance("viscosityy", "viscosity"), 1);
  EXPECT_EQ(edit_distance("vicsosity", "viscosity"), 1);
  EXPECT_EQ(edit_distance("Viscosity", "viscosity"), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Nearest, IsTheCandidateWithTheFewestEdits) {
  EXPECT_EQ(nearest("oneway", {"auto", "one_way", "quasi_steady"}), "one_way");
  EXPECT_EQ(nearest("", {"abc", "ab"}), "ab");
  EXPECT_EQ(nearest(std::string(1000000, 'x'), {"abc", "ab"}), "abc");  // and in no time
}

TEST(InQuotes, StaysOnOneLineAndShort) {
  EXPECT_EQ(in_quotes("a\nb\x01"), "\"a\\u000ab\\u0001\"");
  EXPECT_EQ(in_quotes("\xC2\xB5m"), "\"\xC2\xB5m\"");
  const std::string cut = in_quotes(std::string(79, 'x') + "\xC2\xB5 and more");
  EXPECT_EQ(cut, "\"" + std::string(79, 'x') + "...\"") << "cut inside a character";
}

TEST(Shortest, ReadsBackExactlyAndIsNotPadded) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1e-7), "1e-07");
  EXPECT_EQ(std::stod(shortest(1.0 / 3.0)), 1.0 / 3.0);
}

TEST(Alternatives, ReadsAsASentence) {
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace colloid
