// poreclog repair: makes the results database again from the run folders.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_repair();

}  // namespace colloid
