// `poreclog-solve measure`: what a scene's geometry says without time stepping.
#pragma once

#include <memory>

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_measure();

}  // namespace colloid
