// What a run that began now would do with each realisation, and why: reads the folders
// and the database as Ingester::catch_up() does, and changes nothing.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "campaign/attempt_watch.h"
#include "campaign/plan.h"
#include "campaign/run_folder.h"

namespace colloid {

/// Realisations of an ensemble with which the same would be done for the same reason.
struct Prospect {
  std::string action;  ///< run, take_over, ingest, skip or wait
  std::string reason;  ///< one word, for programs
  std::string text;    ///< the reason, for people
  long count = 0;
  std::vector<std::pair<int, int>> indices;  ///< first and last of each range, ascending
};

/// How many realisations of an ensemble are wanted for now: all, or what the campaign's
/// target needs for its next decision or needed.
struct Wanted {
  int realisations = 0;
  bool target_met = false;
};

/// In the order of their first indices.  `database` need not be there; `watch`: who knows
/// of attempts that run elsewhere, null if none do.
std::vector<Prospect> prospects(const Plan& plan, std::size_t ensemble,
                                const RunFolder& folder, const std::string& database,
                                const AttemptWatch* watch, const Wanted& wanted);

}  // namespace colloid
