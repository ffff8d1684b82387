// `poreclog-solve run`: one realisation of a scene into a result file.
#pragma once

#include <memory>

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_run();

}  // namespace colloid
