// The fidelity tiers, the programs that have them, and the choice among them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/realisation.h"
#include "scene/scene.h"
#include "tiers/regime.h"
#include "tiers/run_options.h"

namespace colloid {

constexpr const char* kSolveProgram = "poreclog-solve";
constexpr const char* kTransientProgram = "poreclog-solve-transient";

/// A tier is one function; nothing comes back from an interrupted run.
using TierFunction = std::optional<Realisation> (*)(const Scene&, const RunOptions&);

struct Tier {
  TierChoice choice;
  TierFunction run;
};

/// What a program has.
struct TierTable {
  const char* program;
  std::vector<Tier> tiers;
  // Of a run of several processes:
  bool writes_result = true;              ///< this one is the first
  std::function<bool(bool)> on_all = {};  ///< whether something holds on all of them
};

struct TierDecision {
  Tier tier;
  std::string reason;   ///< for the record
  std::string warning;  ///< for the user: what is asked for but not needed, and its cost
};

/// The tier that `auto` means, and the numbers that say so.
struct TierAdvice {
  TierChoice choice;
  std::string reason;
};

/// The name of the program that has this tier.
const char* program_of(TierChoice choice);

/// The cheapest tier that is valid for the scene: transient where inertia counts, else
/// quasi_steady if bodies are driven, else one_way.
TierAdvice advise_tier(const Scene& scene, const Regime& regime);

/// The regime of the clean pore: without the bodies of the scene.
Regime clean_regime(const Scene& scene, int threads);

/// The tier that the scene asks for, or with `auto` the one advised.  Refuses tiers that
/// this program does not have, naming the one that does.
TierDecision choose_tier(const Scene& scene, const TierTable& table, int threads);

}  // namespace colloid
