// poreclog show: one realisation, its attempts, and the line that repeats it alone.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_show();

}  // namespace colloid
