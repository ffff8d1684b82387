// SIGINT, SIGTERM and SIGCHLD as events to wait for, not as interruptions.
#pragma once

namespace colloid {

class Signals {
 public:
  enum class Event {
    none,   ///< time is up
    child,  ///< a child may have ended
    stop    ///< somebody wants us to stop
  };

  /// Blocks the signals for the whole process: construct before anything else runs.
  Signals();

  /// Waits for the next event, as long as `seconds`.
  Event wait(double seconds) const;
};

}  // namespace colloid
