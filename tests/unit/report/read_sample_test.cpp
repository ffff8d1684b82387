// Tables from elsewhere: what is read, and what is refused with line and reason.
#include "report/read_sample.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    read_sample(text, "t.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadSample, ReadsEveryColumn) {
  const auto read = read_sample(
      "idx,t1_s,tc_s,censored,alpha_deg\n"
      "0,0.5,1.5,0,30\r\n"
      "\n"
      "4,,5.0,1,NA\n",
      "t.csv");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].tc, 1.5);
  EXPECT_EQ(read[0].t1, 0.5);
  EXPECT_EQ(read[0].alpha_deg, 30.0);
  EXPECT_EQ(read[1].index, 4u);
  EXPECT_EQ(read[1].tc, std::nullopt);
  EXPECT_EQ(read[1].t1, std::nullopt);
  EXPECT_EQ(read[1].alpha_deg, std::nullopt);
  EXPECT_EQ(read[1].end, 5.0);
}

TEST(ReadSample, TakesColumnsInAnyOrderAndWithoutAnIndex) {
  const auto read = read_sample("censored,tc_s,remark\n0,2,x\n1,3,y", "t.csv");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].tc, 2.0);
  EXPECT_EQ(read[1].index, 1u);
}

TEST(ReadSample, RefusesWithLineAndReason) {
  EXPECT_THAT(refusal(""), HasSubstr("t.csv: holds no realisation"));
  EXPECT_THAT(refusal("tc_s\n1\n"), HasSubstr("has no column censored"));
  EXPECT_THAT(refusal("tc_s,censored,tc_s\n1,0,1\n"), HasSubstr("column tc_s twice"));
  EXPECT_THAT(refusal("tc_s,censored\n1\n"),
              HasSubstr("t.csv line 2: has 1 fields, expected 2"));
  EXPECT_THAT(refusal("tc_s,censored\n1,0\n2,2\n"),
              HasSubstr("line 3: censored is neither 0 nor 1"));
  EXPECT_THAT(refusal("tc_s,censored\n,1\n"), HasSubstr("the time it reached"));
  EXPECT_THAT(refusal("tc_s,censored\n1s,0\n"), HasSubstr("tc_s is \"1s\""));
  EXPECT_THAT(refusal("tc_s,censored\ninf,0\n"), HasSubstr("expected a number"));
  EXPECT_THAT(refusal("tc_s,censored\n-1,0\n"), HasSubstr("negative time"));
  EXPECT_THAT(refusal("t1_s,tc_s,censored\n3,2,0\n"), HasSubstr("later than tc_s"));
  EXPECT_THAT(refusal("idx,tc_s,censored\n1,2,0\n1,2,0\n"), HasSubstr("idx 1 stands"));
  EXPECT_THAT(refusal("idx,tc_s,censored\n0.5,2,0\n"), HasSubstr("whole number"));
}

}  // namespace
}  // namespace colloid
