// What `describe --injections` shows: the colloids that enter a scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tiers/injection.h"

namespace colloid {

struct InjectionList {
  std::uint64_t seed = 0;
  double duration = 0.0;  ///< of the scene [s]
  CleanInlet inlet;
  double inlet_area = 0.0;  ///< [m^2]
  double mean_rate = 0.0;   ///< phi Q / V_p [1/s]
  std::vector<InjectedColloid>
      colloids;  ///< after those that are there from the beginning

  /// As if the pore stayed clean: volume over its flow rate [s].
  double time_of(const InjectedColloid& colloid) const {
    return colloid.volume / inlet.flow_rate;
  }
};

/// The injections into the scene in file `path` up to its duration.  Refuses more than a
/// list can hold.
InjectionList list_injections(const std::string& path, std::uint64_t seed);

/// {"seed": "7", ..., "injections": [{"index", "volume_m3", "time_s", "position_m"}]}
nlohmann::ordered_json injections_json(const InjectionList& list);

/// The same for people.
std::string injections_table(const InjectionList& list);

}  // namespace colloid
