#include "commands/statistics.h"

#include <iostream>

#include "base/error.h"
#include "base/files.h"
#include "commands/open_campaign.h"
#include "report/campaign_statistics.h"
#include "report/read_sample.h"
#include "report/statistics_json.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

class StatisticsCommand : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    CLI::Option* campaign = add_campaign_option(app, campaign_)->required(false);
    CLI::Option* csv =
        app.add_option("--csv", csv_,
                       "A table from elsewhere instead: columns tc_s and censored (0 or "
                       "1), and if you have them idx, t1_s, alpha_deg");
    campaign->excludes(csv);
    app.add_option("--duration", duration_,
                   "With --csv: the time [s] to which the restricted mean goes, fixed "
                   "before the data were seen")
        ->needs(csv)
        ->check(CLI::PositiveNumber);
    app.add_option("--confidence", confidence_, "With --csv: level of intervals")
        ->needs(csv)
        ->check(CLI::Range(0.5, 0.9999))
        ->capture_default_str();
    app.add_option("--bootstrap", resamples_, "With --csv: resamples")
        ->needs(csv)
        ->check(CLI::Range(100, 1'000'000))
        ->capture_default_str();
    app.add_option("--seed", seed_, "With --csv: of the resampling")
        ->needs(csv)
        ->capture_default_str();
  }

  int run() override {
    require(!campaign_.empty() || !csv_.empty(), "command line",
            "names neither a campaign nor, with --csv, a table");
    const Json statistics = csv_.empty() ? of_campaign() : of_table();
    std::cout << (common_.json ? statistics.dump(1) + "\n" : headlines(statistics));
    return exit_done;
  }

 private:
  Json of_campaign() const {
    const Plan plan = stored_plan(campaign_name(campaign_), common_);
    return campaign_statistics(plan, RunFolder(common_.runs, plan.campaign),
                               absolute(common_.database))
        .json;
  }

  Json of_table() const {
    const auto outcomes = read_sample(read_text_file(csv_), csv_);
    std::vector<std::string> warnings;
    statistics::SummaryOptions options;
    options.bootstrap =
        bootstrap_options(confidence_, resamples_, seed_, outcomes.size(), warnings);
    if (duration_ > 0.0) {
      options.duration = duration_;
    }
    statistics::PointStatistics summary = statistics::summarise(outcomes, options);
    summary.warnings.insert(summary.warnings.end(), warnings.begin(), warnings.end());
    Json point{{"file", csv_}};
    point.update(to_json(summary));
    return {{"schema_version", 1}, {"points", Json::array({std::move(point)})}};
  }

  CommonOptions common_;
  std::string campaign_;
  std::string csv_;
  double duration_ = 0.0;
  double confidence_ = 0.95;
  std::size_t resamples_ = 2000;
  std::uint64_t seed_ = 1;
};

}  // namespace

std::unique_ptr<Command> make_statistics() {
  return std::make_unique<StatisticsCommand>();
}

}  // namespace colloid
