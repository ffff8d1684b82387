// `run` of both programs: one realisation of a scene into a result file.
#pragma once

#include <memory>

#include "commands/command.h"
#include "tiers/tier.h"

namespace colloid {

/// By the program's own tiers.
std::unique_ptr<Command> make_run(TierTable tiers);

}  // namespace colloid
