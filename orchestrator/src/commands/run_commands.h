// run, submit, resume, retry and extend: the commands that work on a campaign's
// realisations.
#pragma once

#include "commands/command.h"

namespace colloid {

std::unique_ptr<Command> make_run();
std::unique_ptr<Command> make_submit();
std::unique_ptr<Command> make_resume();
std::unique_ptr<Command> make_retry();
std::unique_ptr<Command> make_extend();

}  // namespace colloid
