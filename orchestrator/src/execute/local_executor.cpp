#include "execute/local_executor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"

namespace colloid {

namespace {

constexpr double kPace = 0.5;         // [s] our own children wake us by SIGCHLD
constexpr double kPaceAdopted = 0.1;  // [s] others' children do not

/// In the child: a session of its own, so that a Ctrl-C at the terminal reaches only us;
/// no blocked and no ignored signals.
[[noreturn]] void become(char* const* arguments, volatile int& error) {
  sigset_t none{};
  ::sigemptyset(&none);
  ::signal(SIGPIPE, SIG_DFL);
  ::setsid();
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execve(arguments[0], arguments, environ);
  error = errno;
  ::_exit(127);
}

/// vfork() itself instead of posix_spawn(), which gives the child a stack of its own: to
/// map, touch and unmap that is half of what starting a process costs us.  POSIX allows
/// the child no call but exec and _exit; on Linux it is safe because the child calls
/// nothing but the system, we have one thread, and every signal is blocked until the
/// child is another program (a handler would run in our memory).
pid_t spawn(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  sigset_t all{};
  sigset_t before{};
  ::sigfillset(&all);
  ::sigprocmask(SIG_BLOCK, &all, &before);
  volatile int error = 0;  // the child writes to it
  // NOLINTBEGIN(clang-analyzer-security.insecureAPI.vfork, clang-analyzer-unix.Vfork)
  const pid_t child = ::vfork();
  if (child == 0) {
    become(arguments.data(), error);
  }
  // NOLINTEND(clang-analyzer-security.insecureAPI.vfork, clang-analyzer-unix.Vfork)
  if (child < 0) {
    error = errno;
  }
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  if (error != 0) {
    if (child > 0) {
      ::waitpid(child, nullptr, 0);
    }
    throw StorageError(
        fmt::format("{} cannot be started: {}", words[0], std::strerror(error)));
  }
  return child;
}

}  // namespace

LocalExecutor::LocalExecutor(int workers, std::string keeper)
    : workers_(static_cast<std::size_t>(workers)), keeper_(std::move(keeper)) {
  assert(workers > 0);
}

std::size_t LocalExecutor::free_slots() const {
  return workers_ - std::min(workers_, running_.size());
}

void LocalExecutor::submit(const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    std::vector<std::string> words{keeper_, job.folder, fmt::format("{}", job.seconds),
                                   fmt::format("{}", job.seconds_to_stop), "--"};
    words.insert(words.end(), job.command.begin(), job.command.end());
    running_[job.id] = {spawn(words), job.folder};
  }
}

bool LocalExecutor::adopt(const Job& job) {
  const bool runs = is_running(job.folder);
  if (runs) {
    running_[job.id] = {0, job.folder};
  }
  return runs;
}

std::vector<std::int64_t> LocalExecutor::poll() {
  std::vector<std::int64_t> ended;
  for (const auto& [id, job] : running_) {
    // A child of ours has ended when it has been waited for; if it was killed, the solver
    // goes an instant later, and the lock with it.
    const bool gone = job.keeper == 0 || ::waitpid(job.keeper, nullptr, WNOHANG) != 0;
    if (gone && !is_running(job.folder)) {
      ended.push_back(id);
    } else if (gone && job.keeper != 0) {
      running_[id].keeper = 0;
    }
  }
  for (const std::int64_t id : ended) {
    running_.erase(id);
  }
  return ended;
}

void LocalExecutor::cancel(Stop how) {
  for (const auto& [id, job] : running_) {
    const pid_t keeper = job.keeper != 0 ? job.keeper : keeper_of(job.folder).process;
    if (keeper > 0) {
      ::kill(keeper, how == Stop::politely ? SIGTERM : SIGQUIT);
    }
  }
}

double LocalExecutor::pace() const {
  const bool adopted = std::any_of(running_.begin(), running_.end(), [](const auto& job) {
    return job.second.keeper == 0;
  });
  return adopted ? kPaceAdopted : kPace;
}

bool is_running(const std::string& attempt_folder) {
  return FileLock::is_held(attempt_folder + "/lock");
}

Keeper keeper_of(const std::string& attempt_folder) {
  Keeper keeper;
  std::istringstream text(read_if_there(attempt_folder + "/lock").value_or(""));
  text >> keeper.process >> keeper.host;
  return keeper;
}

std::string host_name() {
  static const std::string host = [] {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return std::string(name.data());
  }();
  return host;
}

std::string find_keeper() {
  const std::filesystem::path here =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::string path = (here / "poreclog-attempt").string();
  require(::access(path.c_str(), X_OK) == 0, path,
          "is not there; it belongs beside poreclog");
  return path;
}

}  // namespace colloid
