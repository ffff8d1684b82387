#include "tiers/run_cost.h"

#include <algorithm>

namespace colloid {

NamedNumbers RunCost::so_far(const NamedNumbers& more) const {
  NamedNumbers out{{"wall_seconds", wall_seconds() - wall_},
                   {"cpu_seconds", processor_seconds() - processor_}};
  out.insert(out.end(), more.begin(), more.end());
  for (auto& number : out) {
    const auto earlier = std::find_if(before_.begin(), before_.end(), [&](const auto& b) {
      return b.first == number.first;
    });
    number.second += earlier == before_.end() ? 0.0 : earlier->second;
  }
  return out;
}

}  // namespace colloid
