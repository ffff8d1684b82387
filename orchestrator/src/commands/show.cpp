#include "commands/show.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "campaign/run_folder.h"
#include "campaign/solver_program.h"
#include "commands/open_campaign.h"
#include "store/query.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

class Show : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    add_campaign_option(app, campaign_);
    app.add_option("point", point_, "Number of the design point")->required();
    app.add_option("index", index_, "Index of the realisation")->required();
    app.add_option("--tier", tier_, "If the campaign has several");
    app.add_flag("--command", command_,
                 "Print the command line that repeats this realisation alone, with "
                 "identical datasets");
  }

  int run() override {
    const Plan plan = stored_plan(campaign_name(campaign_), common_);
    const Item item = item_in(plan);
    const RunFolder folder(common_.runs, plan.campaign);
    const Ensemble& ensemble = plan.ensembles[item.ensemble];
    const std::string line = command_line(
        SolverProgram::find(common_.solver)
            .run_command(plan, item, folder.scene_file(ensemble), "result.h5"));
    if (command_ && !common_.json) {
      std::cout << line << "\n";
      return exit_done;
    }
    const Json shown{{"schema_version", 1},
                     {"campaign", plan.campaign},
                     {"point", point_},
                     {"idx", index_},
                     {"tier", ensemble.tier},
                     {"seed", std::to_string(seed_of(plan, item))},
                     {"scene_hash", ensemble.scene_hash},
                     {"folder", folder.realisation(plan, item)},
                     {"command", line},
                     {"realisation", rows("v_realisation", plan, ensemble)},
                     {"attempts", rows("v_attempt", plan, ensemble)},
                     {"incidents", rows("v_incident", plan, ensemble)}};
    std::cout << (common_.json ? shown.dump(2) + "\n" : text_of(shown));
    return exit_done;
  }

 private:
  Item item_in(const Plan& plan) const {
    std::vector<std::string> tiers;
    std::size_t found = plan.ensembles.size();
    for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
      if (plan.ensembles[e].point == point_ &&
          (tier_.empty() || tier_ == plan.ensembles[e].tier)) {
        tiers.push_back(plan.ensembles[e].tier);
        found = e;
      }
    }
    require(!tiers.empty(), "point",
            fmt::format("is {}{}, expected one of the {} design points of {}, from 0",
                        point_, tier_.empty() ? "" : " in tier " + tier_,
                        plan.points.size(), plan.campaign));
    require(tiers.size() == 1, "--tier", "is needed: " + alternatives(tiers));
    require(index_ >= 0 && index_ < plan.realisations, "index",
            fmt::format("is {}, expected 0 to {}", index_, plan.realisations - 1));
    return {found, index_};
  }

  Json rows(const char* view, const Plan& plan, const Ensemble& ensemble) const {
    const std::string database = absolute(common_.database);
    if (!is_file(database)) {
      return Json::array();
    }
    const QueryResult result =
        ask(database,
            fmt::format("SELECT * FROM {} WHERE campaign = :campaign AND point = {} AND "
                        "idx = {} AND ('{}' = 'auto' OR tier = '{}')",
                        view, point_, index_, ensemble.tier, ensemble.tier),
            plan.campaign);
    Json out = Json::array();
    for (const auto& row : result.rows) {
      Json object = Json::object();
      for (std::size_t i = 0; i < row.size(); ++i) {
        object[result.columns[i]] = row[i];
      }
      out.push_back(std::move(object));
    }
    return out;
  }

  static std::string text_of(const Json& shown) {
    std::string out;
    for (const char* key : {"campaign", "point", "idx", "tier", "seed", "folder"}) {
      const Json& value = shown[key];
      out += fmt::format("{:<24}{}\n", key,
                         value.is_string() ? value.get<std::string>() : value.dump());
    }
    for (const Json& row : shown["realisation"]) {
      for (const auto& [key, value] : row.items()) {
        if (!shown.contains(key) && !value.is_null()) {
          out += fmt::format("{:<24}{}\n", key,
                             value.is_string() ? value.get<std::string>() : value.dump());
        }
      }
    }
    for (const Json& row : shown["attempts"]) {
      out += fmt::format(
          "attempt {:<16}{}{}\n", row["attempt"].get<int>(),
          row["cause"].get<std::string>(),
          row["message"].is_null() ? "" : ": " + row["message"].get<std::string>());
    }
    for (const Json& row : shown["incidents"]) {
      out += fmt::format("{}: {}\n", row["kind"].get<std::string>(),
                         row["text"].get<std::string>());
    }
    return out + "again alone: " + shown["command"].get<std::string>() + "\n";
  }

  CommonOptions common_;
  std::string campaign_;
  int point_ = 0;
  int index_ = 0;
  std::string tier_;
  bool command_ = false;
};

}  // namespace

std::unique_ptr<Command> make_show() {
  return std::make_unique<Show>();
}

}  // namespace colloid
