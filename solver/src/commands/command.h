// A subcommand of a program: its options, and what it does with them.
#pragma once

#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

namespace colloid {

/// Exit codes of every program of the solver.
enum ExitCode : int {
  exit_finished = 0,
  exit_refused = 2,        ///< input or command line
  exit_not_converged = 3,  ///< or unstable
  exit_internal = 4,
  exit_interrupted = 5,  ///< with a checkpoint written
};

class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  /// Declares the options on the subcommand `app`; parsing fills them.
  virtual void declare_options(CLI::App& app) = 0;
  /// Runs after parsing; returns an ExitCode, throws what error.h names.
  virtual int run() const = 0;
};

/// A row of a program's table of subcommands.
struct CommandEntry {
  const char* name;
  const char* summary;
  std::function<std::unique_ptr<Command>()> make;
};

}  // namespace colloid
