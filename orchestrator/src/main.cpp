// poreclog: campaigns in, ensembles of results out.  The subcommands are in commands/.
#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"
#include "commands/cancel.h"
#include "commands/check.h"
#include "commands/command.h"
#include "commands/query.h"
#include "commands/repair.h"
#include "commands/report.h"
#include "commands/run_commands.h"
#include "commands/show.h"
#include "commands/statistics.h"
#include "commands/status.h"
#include "git_commit.h"  // written by cmake/GitCommit.cmake at every build

namespace {

using colloid::Command;
using colloid::CommandEntry;

constexpr std::array kCommands{
    CommandEntry{"check", "Check a campaign; print what would run, why, and its cost",
                 colloid::make_check},
    CommandEntry{"run", "Run a campaign, or go on with it", colloid::make_run},
    CommandEntry{"submit", "Hand a campaign to Slurm and return at once",
                 colloid::make_submit},
    CommandEntry{"status", "Print where a campaign stands", colloid::make_status},
    CommandEntry{"resume", "Go on with a campaign that was interrupted",
                 colloid::make_resume},
    CommandEntry{"retry", "Try failed realisations again", colloid::make_retry},
    CommandEntry{"extend", "Add realisations to a campaign", colloid::make_extend},
    CommandEntry{"cancel", "Stop a campaign that another process or Slurm runs",
                 colloid::make_cancel},
    CommandEntry{"query", "Ask the results database", colloid::make_query},
    CommandEntry{"statistics", "Print estimates with intervals, of a campaign or a table",
                 colloid::make_statistics},
    CommandEntry{"report", "Write the report of a campaign: one HTML file",
                 colloid::make_report},
    CommandEntry{"show", "Print one realisation, and how to repeat it alone",
                 colloid::make_show},
    CommandEntry{"repair", "Make the results database again from the run folders",
                 colloid::make_repair},
};

/// What CLI11 would call a missing subcommand is most often a misspelt one.
void require_command(int argc, char** argv) {
  std::vector<std::string> names;
  names.reserve(kCommands.size());
  for (const CommandEntry& entry : kCommands) {
    names.emplace_back(entry.name);
  }
  const std::string known = fmt::format("known: {}", fmt::join(names, ", "));
  colloid::require(argc > 1, "command line", "a command is missing; " + known);
  const std::string word = argv[1];
  colloid::require(
      word.rfind('-', 0) == 0 ||
          std::find(names.begin(), names.end(), word) != names.end(),
      "command line",
      fmt::format("{} is not a command; the nearest is \"{}\"; {}",
                  colloid::in_quotes(word), colloid::nearest(word, names), known));
}

/// The first argument that `parser` does not know, and the option that may be meant.
std::string unknown_argument(const CLI::App& parser) {
  std::vector<std::string> options;
  for (const CLI::Option* option : parser.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      options.push_back("--" + name);
    }
  }
  std::vector<std::string> words = parser.remaining();
  const auto is_option = [](const std::string& word) { return word.rfind("--", 0) == 0; };
  const auto found = std::find_if(words.begin(), words.end(), is_option);
  if (found == words.end() || options.empty()) {
    return fmt::format("one argument too many for {}: {}", parser.get_name(),
                       colloid::in_quotes(words.empty() ? "" : words.front()));
  }
  return fmt::format("{} is not an option of {}; the nearest is {}",
                     colloid::in_quotes(*found), parser.get_name(),
                     colloid::nearest(*found, options));
}

int run(int argc, char** argv) {
  CLI::App program("Runs ensembles of colloids that clog a pore throat");
  program.name("poreclog");
  program.set_version_flag(
      "--version",
      fmt::format("poreclog {} (commit {})", PORECLOG_VERSION, PORECLOG_GIT_COMMIT));
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 all done, 1 refused, 2 finished with failed realisations,\n"
      "3 stopped before the target, 4 interrupted (resumable), 5 internal error.");

  std::vector<std::unique_ptr<Command>> commands;
  std::vector<CLI::App*> parsers;
  for (const CommandEntry& entry : kCommands) {
    commands.push_back(entry.make());
    parsers.push_back(program.add_subcommand(entry.name, entry.summary));
    commands.back()->declare_options(*parsers.back());
  }
  require_command(argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    for (const CLI::App* parser : parsers) {
      if (parser->parsed()) {
        throw colloid::InputError("command line", unknown_argument(*parser));
      }
    }
    throw colloid::InputError("command line", error.what());
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
  std::cerr << fmt::format("poreclog: {}{}\n", kind, error.what());
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const colloid::InputError& error) {
    return complain("", error, colloid::exit_refused);
  } catch (const colloid::StorageError& error) {
    return complain("stopped, can be resumed: ", error, colloid::exit_interrupted);
  } catch (const std::exception& error) {
    return complain("internal error: ", error, colloid::exit_internal);
  }
}
