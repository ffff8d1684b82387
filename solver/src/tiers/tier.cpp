#include "tiers/tier.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "scene/names.h"
#include "tiers/measurement.h"
#include "tiers/transient_cost.h"

namespace colloid {

namespace {

std::string names_of(const TierTable& table) {
  std::string out;
  for (const Tier& tier : table.tiers) {
    out += fmt::format("\"{}\", ", word_of(tier.choice));
  }
  return out + "or \"auto\" where it means " +
         (table.tiers.size() > 1 ? "these" : "this");
}

/// What a tier with inertia costs where it makes no difference.
std::string warning_of(const Scene& scene, const Regime& regime) {
  if (regime.inertia.needed) {
    return "";
  }
  const TierAdvice advice = advise_tier(scene, regime);
  return fmt::format("the scene does not need the tier transient ({}): {} is {}; {}",
                     regime.inertia.reason, word_of(advice.choice), advice.reason,
                     cost_text(predict_transient_cost(scene, regime)));
}

}  // namespace

const char* program_of(TierChoice choice) {
  return choice == TierChoice::transient ? kTransientProgram : kSolveProgram;
}

TierAdvice advise_tier(const Scene& scene, const Regime& regime) {
  if (regime.inertia.needed) {
    return {TierChoice::transient, "inertia counts: " + regime.inertia.reason};
  }
  const auto& bodies = scene.geometry.bodies;
  if (std::any_of(bodies.begin(), bodies.end(),
                  [](const Body& body) { return body.velocity.has_value(); })) {
    return {TierChoice::quasi_steady,
            "the cheapest that is valid with bodies at a velocity"};
  }
  return {TierChoice::one_way, "the cheapest that is valid"};
}

Regime clean_regime(const Scene& scene, int threads) {
  Scene clean = scene;
  clean.geometry.bodies.clear();
  MeasureOptions options;
  options.threads = threads;
  return measure(clean, options).regime;
}

TierDecision choose_tier(const Scene& scene, const TierTable& table, int threads) {
  const bool automatic = scene.fidelity.tier == TierChoice::automatic;
  TierDecision decision{{scene.fidelity.tier, nullptr}, "asked for", ""};
  std::string because;
  if (automatic) {
    const TierAdvice advice = advise_tier(scene, clean_regime(scene, threads));
    decision.tier.choice = advice.choice;
    decision.reason = "auto: " + advice.reason;
    because =
        fmt::format(", which means {} here ({})", word_of(advice.choice), advice.reason);
  }
  const TierChoice choice = decision.tier.choice;
  const auto has = std::find_if(table.tiers.begin(), table.tiers.end(),
                                [&](const Tier& t) { return t.choice == choice; });
  require(has != table.tiers.end(), "/fidelity/tier", [&] {
    return fmt::format("is {}{}; run it with {}: {} has {}", word_of(scene.fidelity.tier),
                       because, program_of(choice), table.program, names_of(table));
  });
  decision.tier = *has;
  if (choice == TierChoice::transient && !automatic) {
    const Regime regime = clean_regime(scene, threads);
    decision.reason += "; " + regime.inertia.reason;
    decision.warning = warning_of(scene, regime);
  }
  return decision;
}

}  // namespace colloid
