// Which realisations of an unfinished ensemble may be looked at.
//
// A late clogging is a long run, so "those that have finished" are the fast ones and
// their mean is too low.  Two samples are not biased by that: the complete prefix in seed
// order, and all that have started, the running ones censored at the physical time they
// have reached.
#pragma once

#include <cstddef>
#include <vector>

#include "statistics/kaplan_meier.h"
#include "statistics/outcome.h"

namespace colloid::statistics {

struct Prefix {
  std::vector<const RealisationOutcome*> finished;  ///< of the prefix, in seed order
  std::size_t n_failed = 0;                         ///< of the prefix
};

/// The longest run of ascending indices from the first in which every realisation has
/// finished or failed.  `outcomes` holds every realisation asked for, in any order, each
/// index once.
Prefix complete_prefix(const std::vector<RealisationOutcome>& outcomes);

/// Times to clogging of finished and running realisations, those without one censored at
/// the time they have reached.
std::vector<Observation> clogging_of_all_started(
    const std::vector<RealisationOutcome>& outcomes);

Observation clogging(const RealisationOutcome& outcome);

/// Time to first retention, censored at the time reached.
Observation first_retention(const RealisationOutcome& outcome);

}  // namespace colloid::statistics
