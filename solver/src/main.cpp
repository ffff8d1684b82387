// poreclog-solve: scenes in, numbers out.  The subcommands are in commands/.
#include <array>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "commands/command.h"
#include "commands/describe.h"
#include "commands/measure.h"
#include "commands/run.h"
#include "core/error.h"
#include "core/version.h"

namespace {

using colloid::Command;
using colloid::CommandEntry;

constexpr std::array<CommandEntry, 3> kCommands{{
    {"run", "Run one realisation of a scene into a result file", colloid::make_run},
    {"measure", "Measure flow, permeability, critical diameter and forces of a scene",
     colloid::make_measure},
    {"describe", "Print the keys of a scene with units, ranges and defaults",
     colloid::make_describe},
}};

int run(int argc, char** argv) {
  CLI::App program("Simulates colloids that clog a pore throat");
  program.name("poreclog-solve");
  program.set_version_flag("--version", colloid::version_text());
  program.require_subcommand(1);

  std::vector<std::unique_ptr<Command>> commands;
  std::vector<CLI::App*> parsers;
  for (const CommandEntry& entry : kCommands) {
    commands.push_back(entry.make());
    parsers.push_back(program.add_subcommand(entry.name, entry.summary));
    commands.back()->declare_options(*parsers.back());
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return program.exit(error);  // --help or --version: prints it
    }
    throw colloid::InputError("command line", error.what());
  }
  for (std::size_t i = 0; i < parsers.size(); ++i) {
    if (parsers[i]->parsed()) {
      return commands[i]->run();
    }
  }
  throw std::logic_error("no subcommand was parsed");
}

int complain(const char* kind, const std::exception& error, int exit_code) {
  std::cerr << fmt::format("poreclog-solve: {}{}\n", kind, error.what());
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes becomes an OutputError
  try {
    return run(argc, argv);
  } catch (const colloid::InputError& error) {
    return complain("", error, colloid::exit_refused);
  } catch (const colloid::ConvergenceError& error) {
    return complain("not converged: ", error, colloid::exit_not_converged);
  } catch (const colloid::OutputError& error) {
    return complain("", error, colloid::exit_internal);
  } catch (const std::exception& error) {
    return complain("internal error: ", error, colloid::exit_internal);
  }
}
