#include "commands/command.h"

namespace colloid {

void CommonOptions::declare(CLI::App& app) {
  app.add_option("--database", database, "The results database")
      ->envname("PORECLOG_DATABASE")
      ->capture_default_str();
  app.add_option("--runs", runs, "The folder of run folders")
      ->envname("PORECLOG_RUNS")
      ->capture_default_str();
  app.add_option("--solver", solver,
                 "The program poreclog-solve (or in PORECLOG_SOLVER; default: the one "
                 "beside this program)");
  app.add_flag("--json", json, "One JSON value instead of text");
}

}  // namespace colloid
