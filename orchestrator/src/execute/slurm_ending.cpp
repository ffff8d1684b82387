#include "execute/slurm_ending.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/files.h"

namespace colloid {

namespace {

using nlohmann::json;

/// Claims an attempt that no task has begun, so that none can: the lock's file is made
/// by whoever comes first, on whatever machine.
bool claim_unbegun(const std::string& folder) {
  const std::string path = folder + "/lock";
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0644);
  if (descriptor >= 0) {
    ::close(descriptor);
    return true;
  }
  if (errno != EEXIST && errno != ENOENT) {
    throw StorageError(fmt::format("{}: cannot be made: {}", path, std::strerror(errno)));
  }
  return false;
}

json ending_of_lost(bool begun, const std::string& word) {
  json ending{{"schema_version", 1}, {"ended", utc_now()}, {"scheduler", word}};
  const bool was_its_turn =
      word == "COMPLETED" || word == "FAILED" || word == "BOOT_FAIL";
  if (!begun && was_its_turn) {
    ending["exit_code"] = 127;  // as a shell says that there is no such program
  } else if (!begun || word == "CANCELLED" || word == "PREEMPTED" || word == "DEADLINE" ||
             word == "REVOKED") {
    ending["stopped"] = "asked";
  } else if (word == "TIMEOUT") {
    ending["stopped"] = "time_limit";
  } else if (word == "OUT_OF_MEMORY") {
    ending["signal"] = 9;
    ending["out_of_memory"] = true;
  } else {
    ending["lost"] = true;
  }
  return ending;
}

}  // namespace

void write_slurm_ending(const std::string& attempt_folder, const std::string& word,
                        const std::string& reason) {
  const bool begun = !claim_unbegun(attempt_folder);
  if (!begun) {
    write_whole(
        attempt_folder + "/stderr",
        fmt::format("its task on Slurm ended before it had begun: {} {}\n", word, reason),
        false);
  }
  write_whole(attempt_folder + "/ending.json", ending_of_lost(begun, word).dump() + "\n",
              false);
}

}  // namespace colloid
