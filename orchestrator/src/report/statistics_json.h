// The statistics of one design point and tier as JSON: the keys that scripts rely on.
//
// Numbers are SI, the unit is in the key.  A number that the sample does not determine is
// null, and the note beside it says why.  Every interval names its method.
#pragma once

#include <nlohmann/json.hpp>

#include "statistics/summary.h"

namespace colloid {

nlohmann::ordered_json to_json(const statistics::PointStatistics& point);

/// [low, high], null without an interval.
nlohmann::ordered_json pair_of(const std::optional<statistics::Interval>& interval);

/// Survival curves as steps with their intervals, of which a page shows at most `most`
/// steps; 0: all.
nlohmann::ordered_json survival_json(const statistics::KaplanMeier& curve,
                                     std::size_t most);

}  // namespace colloid
