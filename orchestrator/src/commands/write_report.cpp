#include "commands/write_report.h"

#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "campaign/run_folder.h"
#include "campaign/solver_program.h"
#include "git_commit.h"  // written by cmake/GitCommit.cmake at every build
#include "report/page.h"
#include "report/report_content.h"

namespace colloid {

namespace {

/// A report can be made where there is no solver: it then has no regime, and says so.
std::optional<SolverProgram> solver_if_there(const CommonOptions& options) {
  if (options.solver) {
    return SolverProgram::find(options.solver);
  }
  try {
    return SolverProgram::find(std::nullopt);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

WrittenReport write_report(const Plan& plan, const CommonOptions& options,
                           const std::string& output) {
  const RunFolder folder(options.runs, plan.campaign);
  const std::string database = absolute(options.database);
  WrittenReport report;
  report.folder = absolute(output.empty() ? "results/reports/" + plan.campaign : output);
  report.page = report.folder + "/report.html";
  const CampaignStatistics statistics = campaign_statistics(plan, folder, database);
  nlohmann::ordered_json content =
      report_content(plan, folder, database, statistics, solver_if_there(options));
  content["made_by"] = {{"version", PORECLOG_VERSION}, {"commit", PORECLOG_GIT_COMMIT}};
  make_folder(report.folder);
  write_whole(report.folder + "/statistics.json", statistics.json.dump(1) + "\n", false);
  write_whole(report.page, report_page(content), false);
  report.headlines = headlines(statistics.json);
  return report;
}

}  // namespace colloid
