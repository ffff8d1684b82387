#include "commands/progress.h"

#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/text.h"

namespace colloid {

namespace {

constexpr double kBarInterval = 0.2;    // [s]
constexpr double kLineInterval = 10.0;  // [s]
constexpr long kBarWidth = 30;          // characters

}  // namespace

Progress::Progress(long total, long done)
    : total_(total),
      before_(done),
      started_(monotonic_seconds()),
      terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (bar_is_open_) {
    std::fputc('\n', stderr);
  }
}

void Progress::show(long ingested, long failed, long active, bool at_once) {
  const double now = monotonic_seconds();
  if (!at_once && now - shown_ < (terminal_ ? kBarInterval : kLineInterval)) {
    return;
  }
  shown_ = now;
  const long done = ingested + failed;
  const long here = done - before_;
  std::string text = fmt::format("{} of {} done", done, total_);
  if (failed > 0) {
    text += fmt::format(", {} failed", failed);
  }
  text += fmt::format(", {} running", active);
  if (here > 0 && done < total_) {
    const double left =
        (now - started_) / static_cast<double>(here) * static_cast<double>(total_ - done);
    text += ", about " + duration_text(left) + " left";
  }
  if (terminal_) {
    const long filled = total_ > 0 ? kBarWidth * done / total_ : kBarWidth;
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}\033[K", "", filled, "", kBarWidth - filled,
               text);
    bar_is_open_ = true;
  } else {
    fmt::print(stderr, "{}\n", text);
  }
  std::fflush(stderr);
}

}  // namespace colloid
