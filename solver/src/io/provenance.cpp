#include "io/provenance.h"

#include <array>
#include <ctime>
#include <fstream>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <pwd.h>
#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "core/version.h"
#include "io/hdf5.h"

namespace colloid {

namespace {

constexpr const char* kUnknown = "unknown";

std::string user_name() {
  const passwd* entry = ::getpwuid(::geteuid());
  return entry != nullptr ? entry->pw_name : kUnknown;
}

/// The first "model name" of /proc/cpuinfo; where there is none (ARM), the architecture.
std::string cpu_model() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  utsname system{};
  return ::uname(&system) == 0 ? system.machine : kUnknown;
}

/// Cores the scheduler lets this process use, not those of the machine.
int usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return ::sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 1;
}

std::string hostname() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : kUnknown;
}

/// `argument` as a POSIX shell must be given it.
std::string shell_quoted(const std::string& argument) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos) {
    return argument;
  }
  std::string quoted = "'";
  for (const char c : argument) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::string command_line(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments) {
    line += (line.empty() ? "" : " ") + shell_quoted(argument);
  }
  return line;
}

}  // namespace

Provenance collect_provenance(const std::vector<std::string>& arguments) {
  return {project_version(),
          git_commit(),
          compiler(),
          PORECLOG_COMPILER_FLAGS,
          hdf5_version(),
          user_name(),
          hostname(),
          cpu_model(),
          usable_cores(),
          command_line(arguments),
          fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
}

}  // namespace colloid
