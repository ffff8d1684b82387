// --dry-run: what would run and why, whatever the executor; nothing is run or written.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "commands/command.h"

namespace colloid {

/// The answer of --dry-run under --json.
nlohmann::ordered_json dry_run(const Plan& plan, const CommonOptions& options);

/// The same for people.
std::string dry_run_text(const nlohmann::ordered_json& answer);

}  // namespace colloid
