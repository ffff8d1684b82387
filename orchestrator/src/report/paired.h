// Differences between design points, realisation by realisation.
//
// All design points draw from the same seeds: the same injections, unless what is varied
// changes them.  The difference of two outcomes of one seed then varies less than that of
// independent ones (`sd` against `sd_if_independent`), and its interval is the sharper
// answer to "does this parameter matter?".
#pragma once

#include <nlohmann/json.hpp>

namespace colloid {

struct CampaignStatistics;
struct Plan;

/// Of every design point against the first one in the same tier: mean of t_1 - t_1' and
/// of min(t_c, tau) - min(t_c', tau) over the seeds that both have finished, Student's t.
/// Empty if the points have seeds of their own.
nlohmann::ordered_json paired_differences(const Plan& plan,
                                          const CampaignStatistics& statistics);

}  // namespace colloid
