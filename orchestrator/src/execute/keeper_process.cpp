#include "execute/keeper_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "attempt/protocol.h"
#include "base/error.h"
#include "base/subprocess.h"

namespace colloid {

namespace {

constexpr int kAbove = 10;  // any descriptor above those of the protocol

/// In the child: a session of its own, so that a Ctrl-C at the terminal reaches only us;
/// no ignored signals.  The signals that ask to stop stay blocked: the keeper waits for
/// them, and one that comes before it is ready must not end it.
[[noreturn]] void become(char* const* arguments, int attempts, int endings,
                         volatile int& error) {
  // By way of other numbers: either may be the other's already.
  const int from = ::fcntl(attempts, F_DUPFD_CLOEXEC, kAbove);
  const int to = ::fcntl(endings, F_DUPFD_CLOEXEC, kAbove);
  ::dup2(from, kAttempts);
  ::dup2(to, kEndings);
  sigset_t waited_for{};
  ::sigemptyset(&waited_for);
  for (const int signal : kStopSignals) {
    ::sigaddset(&waited_for, signal);
    ::signal(signal, SIG_DFL);  // a shell that puts us in the background ignores some
  }
  ::signal(SIGPIPE, SIG_DFL);
  ::setsid();
  ::sigprocmask(SIG_SETMASK, &waited_for, nullptr);
  ::execve(arguments[0], arguments, environ);
  error = errno;
  ::_exit(127);
}

/// vfork() as it is meant: the child calls nothing but the system, we have one thread,
/// and every signal is blocked until the child is another program (a handler would run in
/// our memory).  The child has the error at once, which fork() would have to send.
pid_t spawn(const std::string& program, int attempts, int endings) {
  std::string serve = "--serve";
  const std::array<char*, 3> arguments{const_cast<char*>(program.c_str()), serve.data(),
                                       nullptr};
  sigset_t all{};
  sigset_t before{};
  ::sigfillset(&all);
  ::sigprocmask(SIG_BLOCK, &all, &before);
  volatile int error = 0;  // the child writes to it
  // NOLINTBEGIN(clang-analyzer-security.insecureAPI.vfork, clang-analyzer-unix.Vfork)
  const pid_t child = ::vfork();
  if (child == 0) {
    become(arguments.data(), attempts, endings, error);
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
        fmt::format("{} cannot be started: {}", program, std::strerror(error)));
  }
  return child;
}

/// A word of the protocol.
void add(std::string& message, std::string_view word) {
  message += word;
  message += '\0';
}

}  // namespace

KeeperProcess::KeeperProcess(const std::string& program) {
  const auto [attempts, to_keeper] = make_pipe();
  attempts_ = to_keeper;
  const auto [from_keeper, endings] = make_pipe();
  endings_ = from_keeper;
  process_ = spawn(program, attempts, endings);
  ::close(attempts);
  ::close(endings);
  ::fcntl(endings_, F_SETOWN, ::getpid());
  ::fcntl(endings_, F_SETSIG, SIGCHLD);
  ::fcntl(endings_, F_SETFL, O_NONBLOCK | O_ASYNC);
}

KeeperProcess::KeeperProcess(KeeperProcess&& other) noexcept
    : process_(std::exchange(other.process_, 0)),
      attempts_(std::exchange(other.attempts_, -1)),
      endings_(std::exchange(other.endings_, -1)),
      is_busy_(std::exchange(other.is_busy_, false)) {}

KeeperProcess::~KeeperProcess() {
  if (attempts_ >= 0) {
    ::close(attempts_);
  }
  if (endings_ >= 0) {
    ::close(endings_);
  }
  if (process_ > 0 && !is_busy_) {
    ::waitpid(process_, nullptr, 0);  // it ends when nothing more can come
  }
}

bool KeeperProcess::begin(const Job& job) {
  std::string message(sizeof(std::uint32_t), '\0');
  add(message, job.folder);
  add(message, fmt::format("{}", job.seconds));
  add(message, fmt::format("{}", job.seconds_to_stop));
  add(message, job.command_line);
  for (const std::string& word : job.command) {
    add(message, word);
  }
  const auto size = static_cast<std::uint32_t>(message.size() - sizeof(std::uint32_t));
  std::memcpy(message.data(), &size, sizeof size);
  for (std::size_t at = 0; at < message.size();) {
    const ssize_t count = ::write(attempts_, message.data() + at, message.size() - at);
    if (count < 0) {
      return false;
    }
    at += static_cast<std::size_t>(count);
  }
  is_busy_ = true;
  return true;
}

std::optional<int> KeeperProcess::ending() {
  std::int32_t code = 0;
  const ssize_t count = ::read(endings_, &code, sizeof code);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
    return std::nullopt;
  }
  is_busy_ = false;
  return count == static_cast<ssize_t>(sizeof code) ? code : kGone;
}

}  // namespace colloid
