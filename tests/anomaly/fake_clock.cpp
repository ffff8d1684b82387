// Preloaded into the orchestrator: a clock of the day that goes backwards, an hour at
// every look.  The monotonic clock stays as it is.
#include <atomic>
#include <ctime>

#include <sys/syscall.h>
#include <unistd.h>

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static std::atomic<long> looks{0};
  const long result = ::syscall(SYS_clock_gettime, clock, time);
  if (clock == CLOCK_REALTIME) {
    time->tv_sec -= 3600 * ++looks;
  }
  return static_cast<int>(result);
}
