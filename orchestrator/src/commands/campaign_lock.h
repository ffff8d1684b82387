// One orchestrator works on a campaign at a time.
#pragma once

#include <optional>
#include <string>

#include "base/file_lock.h"
#include "campaign/run_folder.h"

namespace colloid {

/// Takes the campaign's lock; refuses, saying who has it, if another orchestrator does.
FileLock lock_campaign(const RunFolder& folder);

/// The same; none if another has it.
std::optional<FileLock> try_to_lock_campaign(const RunFolder& folder);

}  // namespace colloid
