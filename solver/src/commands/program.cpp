#include "commands/program.h"

#include <csignal>
#include <exception>
#include <memory>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.h"
#include "core/version.h"

namespace colloid {

namespace {

int run(const Program& program, int argc, char** argv) {
  CLI::App app(program.summary);
  app.name(program.name);
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);

  std::vector<std::unique_ptr<Command>> commands;
  std::vector<CLI::App*> parsers;
  for (const CommandEntry& entry : program.commands) {
    commands.push_back(entry.make());
    parsers.push_back(app.add_subcommand(entry.name, entry.summary));
    commands.back()->declare_options(*parsers.back());
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app.exit(error);  // --help or --version: prints it
    }
    throw InputError("command line", error.what());
  }
  for (std::size_t i = 0; i < parsers.size(); ++i) {
    if (parsers[i]->parsed()) {
      return commands[i]->run();
    }
  }
  throw std::logic_error("no subcommand was parsed");
}

}  // namespace

ProgramEnding run_program(const Program& program, int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes becomes an OutputError
  const auto complaint = [&](const char* kind, const std::exception& error, int code) {
    return ProgramEnding{code,
                         fmt::format("{}: {}{}\n", program.name, kind, error.what())};
  };
  try {
    return {run(program, argc, argv), ""};
  } catch (const InputError& error) {
    return complaint("", error, exit_refused);
  } catch (const ConvergenceError& error) {
    return complaint("not converged: ", error, exit_not_converged);
  } catch (const OutputError& error) {
    return complaint("", error, exit_internal);
  } catch (const std::exception& error) {
    return complaint("internal error: ", error, exit_internal);
  }
}

}  // namespace colloid
