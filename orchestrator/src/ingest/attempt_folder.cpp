#include "ingest/attempt_folder.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/clock.h"
#include "base/file_lock.h"
#include "base/files.h"

namespace colloid {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestMessage = 500;  // [byte]
constexpr std::streamoff kTail = 4096;        // [byte]

/// The end of a file that may be long; empty if there is none.
std::string tail_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) {
    return "";
  }
  const auto size = static_cast<std::streamoff>(file.tellg());
  file.seekg(std::max(std::streamoff{0}, size - kTail));
  std::string text(static_cast<std::size_t>(std::min(size, kTail)), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max(file.gcount(), std::streamsize{0})));
  return text;
}

/// The last line that says anything; what is not UTF-8 replaced.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) {
    return "";
  }
  const std::size_t newline = text.find_last_of('\n', end);
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  const std::string line = text.substr(begin, std::min(end + 1 - begin, kLongestMessage));
  const std::string quoted =
      json(line).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(quoted).get<std::string>();
}

Cause cause_of_signal(int signal, bool out_of_memory) {
  if (signal == SIGKILL) {
    return out_of_memory ? Cause::out_of_memory : Cause::killed;
  }
  return signal == SIGTERM || signal == SIGINT || signal == SIGHUP ? Cause::killed
                                                                   : Cause::crashed;
}

Cause cause_of_exit(int exit_code) {
  switch (exit_code) {
    case 0:
      return Cause::no_result;
    case 2:
      return Cause::refused;
    case 3:
      return Cause::not_converged;
    case 4:
      return Cause::internal_error;
    case 5:
      return Cause::killed;  // a polite stop, but not by us
    case 127:
      return Cause::not_started;
    default:
      return Cause::internal_error;
  }
}

/// `ending`: the keeper's record.
Cause cause_of(const json& ending, const AttemptRecord& attempt) {
  if (ending.value("lost", false)) {
    return Cause::lost;
  }
  const json& stopped = ending.contains("stopped") ? ending["stopped"] : json();
  if (stopped == "time_limit") {
    return Cause::time_limit;
  }
  if (stopped == "asked") {
    return Cause::interrupted;
  }
  return attempt.signal
             ? cause_of_signal(*attempt.signal, ending.value("out_of_memory", false))
             : cause_of_exit(attempt.exit_code.value_or(4));
}

template <class Value>
std::optional<Value> value_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? std::optional(found->get<Value>())
                                                     : std::nullopt;
}

}  // namespace

AttemptRecord read_attempt(const std::string& folder, int number,
                           const std::string& command) {
  AttemptRecord attempt;
  attempt.number = number;
  attempt.command =
      command.empty() ? read_if_there(folder + "/command").value_or("") : command;
  while (!attempt.command.empty() && attempt.command.back() == '\n') {
    attempt.command.pop_back();
  }
  const json ending =
      json::parse(read_if_there(folder + "/ending.json").value_or(""), nullptr, false);
  if (!ending.is_object()) {
    attempt.cause = Cause::lost;
    return attempt;
  }
  attempt.exit_code = value_at<int>(ending, "exit_code");
  attempt.signal = value_at<int>(ending, "signal");
  attempt.started = ending.value("started", "");
  attempt.ended = ending.value("ended", "");
  attempt.wall_seconds = value_at<double>(ending, "wall_s").value_or(kUndefined);
  attempt.cpu_seconds = value_at<double>(ending, "cpu_s").value_or(kUndefined);
  attempt.memory_kB = value_at<std::int64_t>(ending, "memory_kB");
  attempt.node = ending.value("node", "");
  attempt.cause = cause_of(ending, attempt);
  return attempt;
}

std::string last_message(const std::string& folder) {
  return last_line(tail_of(folder + "/stderr"));
}

bool on_another_machine(const std::string& folder) {
  const std::string lock = read_if_there(folder + "/lock").value_or("");
  const std::size_t space = lock.find(' ');
  if (space == std::string::npos) {
    return false;
  }
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  const std::size_t end = lock.find_first_of(" \n", space + 1);
  return lock.substr(space + 1, end - space - 1) != name.data();
}

Presence presence_here(const std::string& folder) {
  const bool left_something =
      is_file(folder + "/ending.json") || is_file(folder + "/result.h5");
  return !left_something && on_another_machine(folder) ? Presence::unknown
         : FileLock::is_held(folder + "/lock")         ? Presence::active
                                                       : Presence::ended;
}

bool give_up(const std::string& folder) {
  // One word: of two, the second is a machine's name (on_another_machine), also if we are
  // killed before the ending is written.
  const auto lock = FileLock::take(folder + "/lock", "abandoned\n");
  if (!lock) {
    return false;
  }
  if (!read_if_there(folder + "/ending.json")) {
    const json ending{{"schema_version", 1}, {"lost", true}, {"ended", utc_now()}};
    write_whole(folder + "/ending.json", ending.dump() + "\n", false);
  }
  return true;
}

}  // namespace colloid
