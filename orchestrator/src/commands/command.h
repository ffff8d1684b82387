// A subcommand of poreclog: its options, and what it does with them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace colloid {

enum ExitCode : int {
  exit_done = 0,         ///< all done and target met
  exit_refused = 1,      ///< command line, campaign or scene
  exit_failures = 2,     ///< finished, with failed or contradicting realisations
  exit_stopped = 3,      ///< stopped before the target
  exit_interrupted = 4,  ///< by a signal, or a disk or database that failed: resumable
  exit_internal = 5      ///< an error of the program
};

/// What every command takes.
struct CommonOptions {
  std::string database = "results/poreclog.sqlite";
  std::string runs = "results/runs";
  std::optional<std::string> solver;
  bool json = false;

  void declare(CLI::App& app);
};

class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  /// Declares the options on the subcommand `app`; parsing fills them.
  virtual void declare_options(CLI::App& app) = 0;
  /// Runs after parsing; returns an ExitCode, throws what base/error.h names.
  virtual int run() = 0;
};

/// A row of the program's table of subcommands.
struct CommandEntry {
  const char* name;
  const char* summary;
  std::unique_ptr<Command> (*make)();
};

}  // namespace colloid
