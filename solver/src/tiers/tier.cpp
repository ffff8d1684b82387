#include "tiers/tier.h"

#include <array>

#include <fmt/format.h>

#include "core/error.h"
#include "scene/names.h"
#include "tiers/one_way.h"
#include "tiers/quasi_steady.h"

namespace colloid {

namespace {

constexpr std::array<Tier, 2> kTiers{
    {{"one_way", run_one_way}, {"quasi_steady", run_quasi_steady}}};

}  // namespace

TierDecision choose_tier(const Scene& scene) {
  const TierChoice choice = scene.fidelity.tier;
  if (choice == TierChoice::automatic) {
    // Whether it is valid for the scene is the tier's own check: it has the flow.
    return {kTiers.front(), "auto: the cheapest tier"};
  }
  const char* name = Words<TierChoice>::kValue[static_cast<std::size_t>(choice)];
  for (const Tier& tier : kTiers) {
    if (name == std::string(tier.name)) {
      return {tier, "asked for"};
    }
  }
  throw InputError("/fidelity/tier",
                   fmt::format("is \"{}\", which this program does not have yet; "
                               "expected \"one_way\", \"quasi_steady\" or \"auto\"",
                               name));
}

}  // namespace colloid
