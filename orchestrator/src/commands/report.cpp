#include "commands/report.h"

#include <iostream>

#include <fmt/format.h>

#include "commands/open_campaign.h"
#include "commands/write_report.h"

namespace colloid {

namespace {

class ReportCommand : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    add_campaign_option(app, campaign_);
    app.add_option("--output", output_,
                   "Folder for report.html and statistics.json (default: "
                   "results/reports/<campaign>)")
        ->envname("PORECLOG_OUTPUT");
  }

  int run() override {
    const Plan plan = stored_plan(campaign_name(campaign_), common_);
    const WrittenReport report = write_report(plan, common_, output_);
    if (common_.json) {
      std::cout << nlohmann::ordered_json{{"schema_version", 1},
                                          {"campaign", plan.campaign},
                                          {"report", report.page},
                                          {"statistics",
                                           report.folder + "/statistics.json"}}
                       .dump(2)
                << "\n";
    } else {
      std::cout << report.headlines << "report: " << report.page << "\n";
    }
    return exit_done;
  }

 private:
  CommonOptions common_;
  std::string campaign_;
  std::string output_;
};

}  // namespace

std::unique_ptr<Command> make_report() {
  return std::make_unique<ReportCommand>();
}

}  // namespace colloid
