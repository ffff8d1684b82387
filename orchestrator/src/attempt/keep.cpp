#include "attempt/keep.h"

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "attempt/protocol.h"

namespace colloid {

namespace {

constexpr int kNotStarted = 127;  // as a shell says it

struct Ending {
  int status = 0;
  rusage usage{};
  double seconds = 0.0;
  const char* stopped = nullptr;  ///< time_limit or asked
  long out_of_memory = 0;         ///< kills for want of memory meanwhile, on this machine
};

sigset_t waited_for() {
  sigset_t signals{};
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGCHLD);
  for (const int signal : kStopSignals) {
    ::sigaddset(&signals, signal);
  }
  return signals;
}

timespec now(clockid_t clock) {
  timespec t{};
  ::clock_gettime(clock, &t);
  return t;
}

double seconds_since(const timespec& start) {
  const timespec t = now(CLOCK_MONOTONIC);
  return static_cast<double>(t.tv_sec - start.tv_sec) +
         1e-9 * static_cast<double>(t.tv_nsec - start.tv_nsec);
}

void print_utc(std::FILE* file, const char* key, const timespec& t) {
  std::tm parts{};
  ::gmtime_r(&t.tv_sec, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &parts);
  std::fprintf(file, "\"%s\": \"%s.%03ldZ\", ", key, text.data(), t.tv_nsec / 1000000);
}

/// The kernel's count of processes killed for want of memory; 0 if it does not say.
long kills_for_memory() {
  std::FILE* file = std::fopen("/proc/vmstat", "re");
  long count = 0;
  if (file != nullptr) {
    std::array<char, 128> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), file) != nullptr) {
      if (std::strncmp(line.data(), "oom_kill ", 9) == 0) {
        count = std::strtol(line.data() + 9, nullptr, 10);
      }
    }
    std::fclose(file);
  }
  return count;
}

/// Makes the attempt's folder, goes there and writes its command: 0, or errno.
int enter_new_folder(const char* folder, const char* line) {
  std::array<char, PATH_MAX> around{};
  const char* end = std::strrchr(folder, '/');
  if (end != nullptr && end != folder) {
    std::snprintf(around.data(), around.size(), "%.*s", static_cast<int>(end - folder),
                  folder);
    if (::mkdir(around.data(), 0755) != 0 && errno != EEXIST) {
      return errno;
    }
  }
  if (::mkdir(folder, 0755) != 0 || ::chdir(folder) != 0) {
    return errno;
  }
  const int file = ::open("command", O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0 || ::dprintf(file, "%s\n", line) < 0 || ::close(file) != 0) {
    return errno;
  }
  return 0;
}

/// Takes the lock: its descriptor, or -1 if another has it, or if this attempt has been
/// given up: who takes an attempt for lost holds the lock while it writes an ending, or
/// has made its file.
int hold_lock(const char* job) {
  const int once = job == nullptr ? 0 : O_EXCL;
  const int descriptor =
      ::open("lock", O_RDWR | O_CREAT | once, 0644);  // inherited on purpose
  if (descriptor < 0) {
    return -1;
  }
  struct flock request {};
  request.l_type = F_WRLCK;
  request.l_whence = SEEK_SET;
  bool held = ::fcntl(descriptor, F_OFD_SETLK, &request) == 0 || job != nullptr;
  if (held && ::access("ending.json", F_OK) == 0) {
    errno = EEXIST;
    held = false;
  }
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  if (held &&
      ::dprintf(descriptor, "%d %s%s%s\n", static_cast<int>(::getpid()), host.data(),
                job == nullptr ? "" : " ", job == nullptr ? "" : job) > 0) {
    return descriptor;
  }
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return -1;
}

void redirect(const char* path, int to) {
  const int descriptor = ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor >= 0) {
    ::dup2(descriptor, to);
    ::close(descriptor);
  }
}

[[noreturn]] void become(char* const* command, pid_t keeper) {
  redirect("stdout", STDOUT_FILENO);
  redirect("stderr", STDERR_FILENO);
  // The solver dies with its keeper; a keeper that died before this line is not missed.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != keeper) {
    ::_exit(kNotStarted);
  }
  ::setpgid(0, 0);
  ::signal(SIGPIPE, SIG_DFL);
  const sigset_t signals = waited_for();
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  ::execvp(command[0], command);
  std::fprintf(stderr, "cannot be started: %s: %s\n", command[0], std::strerror(errno));
  ::_exit(kNotStarted);
}

/// Waits for the solver, stopping it when it must.
Ending watch(pid_t solver, double limit, double grace) {
  const sigset_t signals = waited_for();
  const timespec start = now(CLOCK_MONOTONIC);
  Ending ending;
  double deadline = limit;
  bool term_sent = false;
  while (::wait4(solver, &ending.status, WNOHANG, &ending.usage) != solver) {
    const double left = deadline - seconds_since(start);
    if (left <= 0.0) {
      ::kill(-solver, term_sent ? SIGKILL : SIGTERM);
      ending.stopped = ending.stopped == nullptr ? "time_limit" : ending.stopped;
      deadline = seconds_since(start) + (term_sent ? 1.0 : grace);
      term_sent = true;
      continue;
    }
    timespec wait{};
    wait.tv_sec = static_cast<time_t>(left);
    wait.tv_nsec = static_cast<long>((left - static_cast<double>(wait.tv_sec)) * 1e9);
    const int signal = ::sigtimedwait(&signals, nullptr, &wait);
    if (signal == SIGTERM || signal == SIGINT) {
      ending.stopped = ending.stopped == nullptr ? "asked" : ending.stopped;
      deadline = term_sent ? deadline : seconds_since(start);
    } else if (signal == SIGQUIT) {
      ending.stopped = ending.stopped == nullptr ? "asked" : ending.stopped;
      ::kill(-solver, SIGKILL);
    }
  }
  ::kill(-solver, SIGKILL);  // what it may have left running
  // A scheduler tells the solver and us at once: it may have been the quicker.
  const timespec no_time{};
  for (int signal = 0; signal >= 0 && ending.stopped == nullptr;) {
    signal = ::sigtimedwait(&signals, nullptr, &no_time);
    if (signal == SIGTERM || signal == SIGINT || signal == SIGQUIT) {
      ending.stopped = "asked";
    }
  }
  ending.seconds = seconds_since(start);
  return ending;
}

double cpu_seconds(const rusage& usage) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

bool write_ending(const Ending& ending, const timespec& started) {
  std::FILE* file = std::fopen("ending.json.part", "we");
  if (file == nullptr) {
    return false;
  }
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  std::fprintf(file, "{\"schema_version\": 1, ");
  print_utc(file, "started", started);
  print_utc(file, "ended", now(CLOCK_REALTIME));
  if (WIFEXITED(ending.status)) {
    std::fprintf(file, "\"exit_code\": %d, \"signal\": null, ",
                 WEXITSTATUS(ending.status));
  } else {
    std::fprintf(file, "\"exit_code\": null, \"signal\": %d, ", WTERMSIG(ending.status));
  }
  std::fprintf(file, "\"stopped\": %s%s%s, \"out_of_memory\": %s, ",
               ending.stopped == nullptr ? "" : "\"",
               ending.stopped == nullptr ? "null" : ending.stopped,
               ending.stopped == nullptr ? "" : "\"",
               ending.out_of_memory > 0 ? "true" : "false");
  std::fprintf(
      file, "\"wall_s\": %.6f, \"cpu_s\": %.6f, \"memory_kB\": %ld, \"node\": \"%s\"}\n",
      ending.seconds, cpu_seconds(ending.usage), ending.usage.ru_maxrss, host.data());
  const bool written = std::ferror(file) == 0;
  return std::fclose(file) == 0 && written &&
         std::rename("ending.json.part", "ending.json") == 0;
}

}  // namespace

void block_signals() {
  const sigset_t signals = waited_for();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

int keep(const Attempt& attempt) {
  const bool is_new = attempt.job == nullptr;
  const int error = is_new ? enter_new_folder(attempt.folder, attempt.line) : 0;
  if (error != 0) {
    return kFolderNotMade + error;
  }
  const int lock = is_new || ::chdir(attempt.folder) == 0 ? hold_lock(attempt.job) : -1;
  if (lock < 0) {
    std::fprintf(stderr, "poreclog-attempt: %s: cannot be used: %s\n", attempt.folder,
                 std::strerror(errno));
    return kNotKept;
  }
  const timespec started = now(CLOCK_REALTIME);
  const long kills_before = kills_for_memory();
  const pid_t keeper = ::getpid();
  const pid_t solver = ::fork();
  if (solver == 0) {
    become(attempt.command, keeper);
  }
  bool written = false;
  if (solver < 0) {
    std::fprintf(stderr, "poreclog-attempt: %s: cannot be started: %s\n", attempt.folder,
                 std::strerror(errno));
  } else {
    ::setpgid(solver, solver);  // here too: the solver may not have come to it yet
    Ending ending = watch(solver, attempt.seconds, attempt.seconds_to_stop);
    ending.out_of_memory =
        WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGKILL
            ? kills_for_memory() - kills_before
            : 0;
    written = write_ending(ending, started);
  }
  ::close(lock);
  return written ? 0 : kNotKept;
}

}  // namespace colloid
