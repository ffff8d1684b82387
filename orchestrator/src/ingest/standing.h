// Where ended attempts leave a realisation that is not ingested.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign.h"
#include "store/store.h"

namespace colloid {

/// failed if its attempts are used up or another one would end in the same way, else
/// eligible.  Attempts up to the number `forgiven` do not count; `folder`: the
/// realisation's.
Status standing(const std::vector<AttemptRecord>& attempts, int forgiven,
                const Limits& limits, const std::string& folder);

}  // namespace colloid
