// poreclog check: is the campaign right, what would run, and what would it cost.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_check();

}  // namespace colloid
