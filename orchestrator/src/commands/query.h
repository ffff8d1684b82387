// poreclog query: questions to the results database.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_query();

}  // namespace colloid
