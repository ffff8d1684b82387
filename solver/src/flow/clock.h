// Clocks for what a solve reports of itself.
#pragma once

#include <chrono>
#include <ctime>

namespace colloid {

/// Wall-clock time [s].
inline double wall_seconds() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Processor time of the program [s]: other programs on the machine are not in it.
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace colloid
