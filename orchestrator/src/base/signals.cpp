#include "base/signals.h"

#include <algorithm>
#include <csignal>
#include <ctime>

namespace colloid {

namespace {

sigset_t watched() {
  sigset_t set{};
  ::sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
    ::sigaddset(&set, signal);
  }
  return set;
}

}  // namespace

Signals::Signals() {
  const sigset_t set = watched();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a reader of our output that went away
}

Signals::Event Signals::wait(double seconds) const {
  const sigset_t set = watched();
  timespec time{};
  time.tv_sec = static_cast<time_t>(std::max(0.0, seconds));
  time.tv_nsec = static_cast<long>(
      (std::max(0.0, seconds) - static_cast<double>(time.tv_sec)) * 1e9);
  const int signal = ::sigtimedwait(&set, nullptr, &time);
  return signal < 0 ? Event::none : signal == SIGCHLD ? Event::child : Event::stop;
}

}  // namespace colloid
