// Which attempts count against a realisation (orchestrator/README.md, table of causes).
#include "ingest/standing.h"

#include <gtest/gtest.h>

namespace colloid {
namespace {

/// Where attempts 1, 2, ... that ended in this way leave a realisation that may fail
/// three times.
Status after(const std::vector<Cause>& causes, int forgiven = 0) {
  Limits limits;
  limits.attempts = 3;
  std::vector<AttemptRecord> attempts;
  for (const Cause cause : causes) {
    AttemptRecord attempt;
    attempt.number = static_cast<int>(attempts.size()) + 1;
    attempt.cause = cause;
    attempts.push_back(attempt);
  }
  return standing(attempts, forgiven, limits, "/nowhere");
}

TEST(Standing, FailuresUseUpTheAttempts) {
  for (const Cause cause :
       {Cause::internal_error, Cause::crashed, Cause::killed, Cause::out_of_memory,
        Cause::time_limit, Cause::no_result, Cause::torn_result, Cause::foreign_result,
        Cause::not_started}) {
    EXPECT_EQ(after({cause, cause}), Status::eligible) << name_of(cause);
    EXPECT_EQ(after({cause, cause, cause}), Status::failed) << name_of(cause);
  }
}

TEST(Standing, InterruptedAndLostAttemptsUseUpNone) {
  for (const Cause cause : {Cause::interrupted, Cause::lost}) {
    EXPECT_EQ(after({cause, cause, cause, cause, Cause::crashed, Cause::crashed}),
              Status::eligible)
        << name_of(cause);
  }
  EXPECT_EQ(after(std::vector<Cause>(99, Cause::lost)), Status::eligible);
  EXPECT_EQ(after(std::vector<Cause>(100, Cause::lost)), Status::failed);
}

TEST(Standing, WhatASolverDoesAgainIsNotTriedAgain) {
  EXPECT_EQ(after({Cause::refused}), Status::failed);
  EXPECT_EQ(after({Cause::not_converged}), Status::failed);
}

TEST(Standing, ForgivenAttemptsDoNotCount) {
  const std::vector<Cause> causes(5, Cause::crashed);
  EXPECT_EQ(after(causes, 2), Status::failed);
  EXPECT_EQ(after(causes, 3), Status::eligible);
  EXPECT_EQ(after({Cause::refused}, 1), Status::eligible);
}

}  // namespace
}  // namespace colloid
