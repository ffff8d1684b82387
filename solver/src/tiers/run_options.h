// What a tier is asked besides the scene, and how it answers while it runs.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace colloid {

/// Where a run is.
struct Progress {
  double time = 0.0;      ///< simulated [s]
  double duration = 0.0;  ///< to be simulated [s]
  long retained = 0;
  double critical_diameter = 0.0;  ///< l_c [m]
};

struct RunOptions {
  std::uint64_t seed = 1;
  std::string tier_reason;             ///< asked for, or chosen: for the record
  std::string checkpoint;              ///< file; empty: none
  double checkpoint_interval = 600.0;  ///< of wall time [s]
  int threads = 1;               ///< of the flow solver; results do not depend on it
  double step_tolerance = 1e-3;  ///< error of a colloid's step over its radius or gap [-]
  const std::atomic<bool>* stop = nullptr;  ///< set by a signal: write a checkpoint, end
  std::function<void(const Progress&)> progress;  ///< called after every step
};

}  // namespace colloid
