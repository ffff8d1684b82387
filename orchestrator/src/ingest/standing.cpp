#include "ingest/standing.h"

#include <filesystem>

#include "campaign/run_folder.h"

namespace colloid {

namespace {

/// A realisation whose attempts are lost so often is given up: something kills them.
constexpr int kMostLost = 100;

/// Then it may have been the checkpoint that was refused, and the next attempt has none.
bool put_a_checkpoint_aside(const std::string& attempt) {
  std::error_code ignored;
  return std::filesystem::exists(attempt + "/checkpoint.refused.h5", ignored);
}

}  // namespace

Status standing(const std::vector<AttemptRecord>& attempts, int forgiven,
                const Limits& limits, const std::string& folder) {
  int failures = 0;
  int lost = 0;
  bool hopeless = false;
  for (const AttemptRecord& attempt : attempts) {
    if (attempt.number <= forgiven) {
      continue;
    }
    failures += counts_as_failure(attempt.cause) ? 1 : 0;
    lost += attempt.cause == Cause::lost ? 1 : 0;
    hopeless = hopeless ||
               (counts_as_failure(attempt.cause) && !is_worth_retrying(attempt.cause) &&
                !(attempt.cause == Cause::refused &&
                  put_a_checkpoint_aside(attempt_folder(folder, attempt.number))));
  }
  return hopeless || failures >= limits.attempts || lost >= kMostLost ? Status::failed
                                                                      : Status::eligible;
}

}  // namespace colloid
