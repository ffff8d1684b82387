#include "commands/check.h"

#include <algorithm>
#include <iostream>
#include <thread>

#include <fmt/format.h>

#include "base/files.h"
#include "base/text.h"
#include "campaign/run_folder.h"
#include "campaign/solver_program.h"
#include "campaign/target.h"
#include "commands/open_campaign.h"
#include "store/database.h"
#include "store/schema.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using namespace nlohmann::literals;

/// What one realisation costs, and how that is known.
struct Cost {
  std::optional<double> seconds;  ///< of wall time
  std::string basis;
};

/// Realisations of an ensemble that are in the database, and the mean of their time.
struct Past {
  long ingested = 0;
  long failed = 0;
  std::optional<double> seconds;
};

Past past_of(const Plan& plan, const Ensemble& ensemble, const std::string& path) {
  Past past;
  if (!is_file(path)) {
    return past;
  }
  const Database database(path, Database::Access::read_only);
  check_schema(database);
  Statement ask = database.prepare(
      "SELECT sum(status = 'ingested'), sum(status = 'failed'), avg(wall_s) "
      "FROM v_realisation WHERE campaign = ? AND point = ? AND tier = ?");
  ask.bind(1, plan.campaign).bind(2, ensemble.point).bind(3, ensemble.tier);
  if (ask.step()) {
    past.ingested = ask.integer(0);
    past.failed = ask.integer(1);
    past.seconds = ask.is_null(2) ? std::nullopt : std::optional(ask.real(2));
  }
  return past;
}

Cost cost_of(const nlohmann::json& regime, const Past& past, const Plan& plan) {
  const nlohmann::json::json_pointer predicted("/cost/seconds");
  if (past.seconds) {
    return {past.seconds, "mean of the realisations that are there"};
  }
  if (regime.contains(predicted) && regime[predicted].is_number()) {
    return {regime[predicted].get<double>() / plan.ranks, "predicted by the solver"};
  }
  return {std::nullopt, fmt::format("not known; at most the limit of {} each",
                                    duration_text(plan.limits.seconds_per_realisation))};
}

class Check : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    add_campaign_option(app, campaign_);
  }

  int run() override {
    const OpenedCampaign opened = open_campaign(campaign_, common_);
    const Plan& plan = opened.plan;
    const Json plan_json = described(plan);
    std::cout << (common_.json ? plan_json.dump(2) + "\n" : text_of(plan_json));
    return exit_done;
  }

 private:
  Json described(const Plan& plan) const {
    const SolverProgram solver = SolverProgram::find(common_.solver);
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const int workers =
        plan.limits.workers > 0 ? plan.limits.workers : std::max(1, cores / plan.ranks);
    Json ensembles = Json::array();
    long to_run = 0;
    std::optional<double> core_seconds = 0.0;
    for (const Ensemble& e : plan.ensembles) {
      const nlohmann::json regime = e.regime.empty() ? solver.regime(e.scene) : e.regime;
      const Past past = past_of(plan, e, absolute(common_.database));
      const Cost cost = cost_of(regime, past, plan);
      const long left = plan.realisations - past.ingested - past.failed;
      to_run += left;
      core_seconds =
          core_seconds && (cost.seconds || left == 0)
              ? std::optional(*core_seconds + cost.seconds.value_or(0.0) *
                                                  static_cast<double>(left) * plan.ranks)
              : std::nullopt;
      ensembles.push_back({{"point", e.point},
                           {"varied", values_of(plan, e.point)},
                           {"tier", e.tier},
                           {"runs_as", e.runs_as},
                           {"tier_reason", regime.value("/tier/reason"_json_pointer,
                                                        std::string("asked for"))},
                           {"realisations", plan.realisations},
                           {"ingested", past.ingested},
                           {"failed", past.failed},
                           {"to_run", left},
                           {"seconds_each", cost.seconds ? Json(*cost.seconds) : Json()},
                           {"seconds_basis", cost.basis},
                           {"models", regime.value("models", nlohmann::json())},
                           {"reasons", regime.value("reasons", nlohmann::json())},
                           {"regime", regime}});
    }
    const auto target = target_of(plan.statistics, plan.realisations);
    return {
        {"schema_version", 1},
        {"campaign", plan.campaign},
        {"master_seed", plan.master_seed},
        {"executor", plan.executor},
        {"workers", workers},
        {"ranks", plan.ranks},
        {"realisations", static_cast<long>(plan.ensembles.size()) * plan.realisations},
        {"to_run", to_run},
        {"target", target ? Json(aim_of(*target)) : Json()},
        {"target_first_look", target ? Json(target->pilot) : Json()},
        {"target_batch", target ? Json(target->batch) : Json()},
        {"core_hours", core_seconds ? Json(*core_seconds / 3600.0) : Json()},
        {"seconds", core_seconds ? Json(*core_seconds / plan.ranks / workers) : Json()},
        {"ensembles", ensembles}};
  }

  static nlohmann::json values_of(const Plan& plan, int number) {
    const auto point = std::find_if(plan.points.begin(), plan.points.end(),
                                    [&](const auto& p) { return p.number == number; });
    return point->values;
  }

  static std::string text_of(const Json& plan) {
    std::string out =
        fmt::format("campaign {}: {} realisations, {} to run, {} at once\n",
                    plan["campaign"].get<std::string>(), plan["realisations"].get<long>(),
                    plan["to_run"].get<long>(), plan["workers"].get<int>());
    if (!plan["target"].is_null()) {
      out += fmt::format(
          "each design point stops when {}: decided after {} "
          "realisations, then every {}; what is said here is the most\n",
          plan["target"].get<std::string>(), plan["target_first_look"].get<int>(),
          plan["target_batch"].get<int>());
    }
    for (const Json& e : plan["ensembles"]) {
      const auto tier = e["tier"].get<std::string>();
      const std::string means =
          tier == "auto" ? fmt::format(": {} ({})", e["runs_as"].get<std::string>(),
                                       e["tier_reason"].get<std::string>())
                         : "";
      out += fmt::format("\npoint {}  tier {}{}  {}\n", e["point"].get<int>(), tier,
                         means, e["varied"].dump());
      out += fmt::format("  {} to run of {}; time of one: {}{}\n",
                         e["to_run"].get<long>(), e["realisations"].get<int>(),
                         e["seconds_each"].is_null()
                             ? ""
                             : duration_text(e["seconds_each"].get<double>()) + ", ",
                         e["seconds_basis"].get<std::string>());
      for (const auto& [model, reason] : e["reasons"].items()) {
        const Json needed = e["models"].value(model, Json());
        out += fmt::format("  {:<16}{:<5}{}\n", model,
                           needed.is_null()     ? "-"
                           : needed.get<bool>() ? "yes"
                                                : "no",
                           reason.get<std::string>());
      }
    }
    if (!plan["seconds"].is_null()) {
      out +=
          fmt::format("\nabout {:.3g} core-hours, {}\n", plan["core_hours"].get<double>(),
                      duration_text(plan["seconds"].get<double>()));
    }
    return out;
  }

  CommonOptions common_;
  std::string campaign_;
};

}  // namespace

std::unique_ptr<Command> make_check() {
  return std::make_unique<Check>();
}

}  // namespace colloid
