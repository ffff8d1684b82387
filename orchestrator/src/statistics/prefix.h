// Which realisations of an unfinished ensemble may be looked at.
//
// A late clogging may be a long run, so "those that have finished" are the fast ones and
// their mean is too low: 0.59 of the truth with exponential run times, 32 finished on 16
// workers (tests/unit/statistics/sequence_test.cpp).
//   All that have started, the running ones censored at the physical time they have
//   reached: not biased at any moment.  What survival curves use. The first n in seed
//   order, n fixed beforehand and waited for: not biased.  What a decision to stop uses
//   (stopping.h). The complete prefix at an arbitrary moment: its length depends on the
//   runs in it, so it is still too low (0.71 there), and right once the ensemble is
//   complete.  For want of better it is what means, curves and fits use meanwhile, with a
//   warning.
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

/// The finished and running realisations, in seed order.
std::vector<const RealisationOutcome*> all_started(
    const std::vector<RealisationOutcome>& outcomes);

/// Time to clogging, censored at the time reached.
Observation clogging(const RealisationOutcome& outcome);

/// Runs end at their duration `tau` [s] but for round-off, which must not leave the last
/// moment unobserved: times that differ from it by no more are set to it.
void snap_to(std::vector<Observation>& observations, double tau);

/// Time to first retention, censored at the time reached.
Observation first_retention(const RealisationOutcome& outcome);

}  // namespace colloid::statistics
