// poreclog cancel: stops a campaign that another process works on.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_cancel();

}  // namespace colloid
