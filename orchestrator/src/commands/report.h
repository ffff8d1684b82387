// poreclog report: the statistics and the page of a campaign.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_report();

}  // namespace colloid
