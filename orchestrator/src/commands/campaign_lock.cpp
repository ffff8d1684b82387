#include "commands/campaign_lock.h"

#include <chrono>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/files.h"
#include "execute/local_executor.h"

namespace colloid {

namespace {

constexpr std::chrono::milliseconds kLockWait{20};
constexpr int kLockWaits = 50;

}  // namespace

std::optional<FileLock> try_to_lock_campaign(const RunFolder& folder) {
  return FileLock::take(folder.lock_file(),
                        fmt::format("{} {} {}\n", ::getpid(), host_name(), utc_now()));
}

FileLock lock_campaign(const RunFolder& folder) {
  // A child that a killed orchestrator had just forked holds its lock until it executes.
  for (int wait = 0; wait < kLockWaits; ++wait) {
    if (auto lock = try_to_lock_campaign(folder)) {
      if (!lock->left_behind().empty()) {
        fmt::print(stderr, "the last poreclog on this campaign was killed; going on\n");
      }
      return std::move(*lock);
    }
    std::this_thread::sleep_for(kLockWait);
  }
  std::string other = read_if_there(folder.lock_file()).value_or("");
  other = other.substr(0, other.find('\n'));
  throw InputError(folder.path(),
                   fmt::format("another poreclog is at work on this campaign (process, "
                               "machine, since: {}); `poreclog cancel` stops it",
                               other));
}

}  // namespace colloid
