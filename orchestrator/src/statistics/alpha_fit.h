// Time from first retention to clogging against the angle of the first attachment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "statistics/censored_fit.h"
#include "statistics/linear_fit.h"
#include "statistics/outcome.h"

namespace colloid::statistics {

/// One realisation in the plane of angle and time.
struct AlphaPoint {
  std::uint64_t index = 0;
  double alpha_deg = 0.0;
  double duration = 0.0;  ///< t_c - t_1 [s], or until the end if censored
  bool censored = false;
  std::optional<double> diameter_lost;  ///< l_c lost to the first retention [m]
};

struct AlphaFit {
  std::vector<AlphaPoint> points;  ///< every realisation with an angle
  LinearFit line;                  ///< through those that clogged
  std::size_t n_excluded = 0;      ///< of the line: censored, or without an angle
  /// Through all points; only if any is censored, as it is the line otherwise.
  std::optional<CensoredFit> with_censored;
};

AlphaFit alpha_fit(const std::vector<const RealisationOutcome*>& outcomes, double level);

}  // namespace colloid::statistics
