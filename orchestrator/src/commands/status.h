// poreclog status: where a campaign stands.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_status();

}  // namespace colloid
