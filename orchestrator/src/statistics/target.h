// How well an ensemble knows one of its headline numbers: what a decision to stop
// compares with the half-width asked for (stopping.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/outcome.h"

namespace colloid::statistics {

/// The numbers that may be aimed at, named as in the output of `poreclog statistics`:
/// t1, tc, tc_minus_t1 (mean, Student's t), median_s (Brookmeyer & Crowley),
/// restricted_mean_s (Greenwood), probability_by_end (Clopper & Pearson).
const std::vector<std::string>& target_names();

/// s, or empty for a probability.
std::string unit_of_target(const std::string& name);

/// Half the width of that number's interval from these realisations, all of which have
/// finished or failed; the failed ones are left out.  None if the sample does not
/// determine it: a mean of times of which one is censored, a median whose interval is
/// open.  `tau`: the campaign's duration [s].
std::optional<double> half_width_of(const std::string& name,
                                    const std::vector<RealisationOutcome>& outcomes,
                                    const std::optional<double>& tau, double level);

}  // namespace colloid::statistics
