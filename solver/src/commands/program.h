// What the solver's programs share: a table of subcommands, one line for an error, exit
// codes.
#pragma once

#include <string>
#include <vector>

#include "commands/command.h"

namespace colloid {

struct Program {
  const char* name;
  const char* summary;
  std::vector<CommandEntry> commands;
};

struct ProgramEnding {
  int exit_code = exit_finished;
  std::string complaint;  ///< a line for stderr; empty: nothing to say
};

/// Parses the command line and runs its subcommand; every exception ends here.
ProgramEnding run_program(const Program& program, int argc, char** argv);

}  // namespace colloid
