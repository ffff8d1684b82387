// What one realisation gives to the statistics.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "statistics/mean_curve.h"

namespace colloid::statistics {

/// finished: reached its duration or clogged.  running: has got to `end` so far.
/// failed: gave no result and will not; it is counted, not censored, as a failure near
/// clogging depends on the answer.  pending: not started.
enum class Progress { finished, running, failed, pending };

struct RealisationOutcome {
  std::uint64_t index = 0;  ///< within its design point: the order of the seeds
  Progress progress = Progress::finished;
  double end = 0.0;                     ///< physical time reached [s]
  std::optional<double> t1;             ///< first retention on a collector [s]
  std::optional<double> tc;             ///< clogging [s]; none: censored at `end`
  std::optional<double> alpha_deg;      ///< elevation angle of the first attachment [deg]
  std::optional<double> diameter_lost;  ///< l_c before less after the first retention [m]
  StepSeries critical_diameter;         ///< [m]; empty if not recorded
  StepSeries permeability_ratio;        ///< [-]; empty if not recorded
  /// Where the first retained colloids came in, in the order of retention [m].
  std::vector<std::array<double, 2>> injection_positions;
};

}  // namespace colloid::statistics
