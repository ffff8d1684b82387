// poreclog statistics: the numbers of a campaign, or of a table from elsewhere.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_statistics();

}  // namespace colloid
