#include "commands/status.h"

#include <array>
#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "base/signals.h"
#include "campaign/run_folder.h"
#include "commands/campaign_lock.h"
#include "commands/open_campaign.h"
#include "commands/slurm_campaign.h"
#include "execute/local_executor.h"
#include "ingest/attempt_folder.h"
#include "report/target_watch.h"
#include "store/database.h"
#include "store/schema.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kWatchInterval = 2.0;  // [s]
constexpr std::array kCounted{"ingested", "failed", "active", "eligible", "unknown"};

class StatusCommand : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    add_campaign_option(app, campaign_);
    app.add_flag("--watch", watch_, "Again every two seconds, until it ends");
  }

  int run() override {
    const Signals signals;
    const std::string name = campaign_name(campaign_);
    const Plan plan = stored_plan(name, common_);
    for (;;) {
      const Json status = status_of(plan);
      std::cout << (common_.json ? status.dump(2) + "\n" : text_of(status)) << std::flush;
      if (!watch_ || !status["running"].get<bool>() ||
          signals.wait(kWatchInterval) == Signals::Event::stop) {
        return exit_done;
      }
    }
  }

 private:
  Json status_of(const Plan& plan) const {
    const RunFolder folder(common_.runs, plan.campaign);
    const bool on_slurm = has_slurm_jobs(plan, folder);
    nlohmann::ordered_json slurm = on_slurm ? fold_in(plan, folder) : Json();
    const bool running = FileLock::is_held(folder.lock_file());
    const Database database(absolute(common_.database), Database::Access::read_only);
    check_schema(database);
    Statement ask = database.prepare(
        "SELECT point, tier, varied, realisations, ingested, failed, active, eligible, "
        "unknown, censored, clogged FROM v_progress WHERE campaign = ? "
        "ORDER BY point, tier");
    ask.bind(1, plan.campaign);
    const TargetWatch target(plan, database);
    Json points = Json::array();
    Json total{{"realisations", 0}, {"ingested", 0}, {"failed", 0},   {"active", 0},
               {"eligible", 0},     {"unknown", 0},  {"censored", 0}, {"clogged", 0}};
    while (ask.step()) {
      Json row{{"point", ask.integer(0)},
               {"tier", ask.text(1)},
               {"varied", Json::parse(ask.text(2))}};
      int column = 3;
      for (const char* key : {"realisations", "ingested", "failed", "active", "eligible",
                              "unknown", "censored", "clogged"}) {
        row[key] = ask.integer(column++);
      }
      if (!running && !on_slurm) {
        look_after_active(plan, folder, database, row);
      }
      for (auto& [key, sum] : total.items()) {
        sum = sum.get<long>() + row[key].get<long>();
      }
      for (std::size_t e = 0; target.has_target() && e < plan.ensembles.size(); ++e) {
        if (plan.ensembles[e].point == row["point"].get<int>() &&
            plan.ensembles[e].tier == row["tier"].get<std::string>()) {
          row["target"] = target.json(e);
        }
      }
      points.push_back(row);
    }
    Statement incidents =
        database.prepare("SELECT count(*) FROM v_incident WHERE campaign = ?");
    incidents.bind(1, plan.campaign).step();
    return {{"schema_version", 1},
            {"campaign", plan.campaign},
            {"running", running || total["active"].get<long>() > 0},
            {"total", total},
            {"points", points},
            {"incidents", incidents.integer(0)},
            {"slurm", slurm}};
  }

  /// Ingests what jobs have left so far, unless an orchestrator does that; where the
  /// tasks are.
  Json fold_in(const Plan& plan, const RunFolder& folder) const {
    const auto lock = try_to_lock_campaign(folder);
    SlurmCampaign slurm(plan, folder);
    if (lock) {
      Store store(absolute(common_.database), plan, folder.path());
      slurm.fold_in(store, folder, plan);
    }
    return slurm.counts();
  }

  /// Without an orchestrator, what the database calls active may have ended since: the
  /// attempts' locks tell.
  static void look_after_active(const Plan& plan, const RunFolder& folder,
                                const Database& database, Json& row) {
    Statement ask = database.prepare(
        "SELECT idx FROM v_realisation WHERE campaign = ? AND point = ? AND tier = ? "
        "AND status = 'active'");
    ask.bind(1, plan.campaign)
        .bind(2, row["point"].get<std::int64_t>())
        .bind(3, row["tier"].get<std::string>());
    while (ask.step()) {
      const Ensemble ensemble{static_cast<int>(row["point"].get<std::int64_t>()),
                              row["tier"].get<std::string>(),
                              {},
                              "",
                              "",
                              {}};
      const std::string realisation =
          fmt::format("{}/{:06}", folder.ensemble(ensemble), ask.integer(0));
      const std::vector<int> attempts = attempts_in(realisation);
      const std::string last =
          attempts.empty() ? "" : attempt_folder(realisation, attempts.back());
      if (!last.empty() && is_running(last)) {
        continue;
      }
      const char* now = !last.empty() && !read_if_there(last + "/ending.json") &&
                                on_another_machine(last)
                            ? "unknown"
                            : "eligible";
      row["active"] = row["active"].get<long>() - 1;
      row[now] = row[now].get<long>() + 1;
    }
  }

  static std::string text_of(const Json& status) {
    std::string out =
        fmt::format("{}: {}\n{:>6} {:<13} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  varied\n",
                    status["campaign"].get<std::string>(),
                    status["running"].get<bool>() ? "running" : "not running", "point",
                    "tier", "all", "ingested", "failed", "active", "eligible", "unknown");
    for (const Json& row : status["points"]) {
      out += fmt::format("{:>6} {:<13} {:>9}", row["point"].get<int>(),
                         row["tier"].get<std::string>(), row["realisations"].get<long>());
      for (const char* key : kCounted) {
        out += fmt::format(" {:>9}", row[key].get<long>());
      }
      out += "  " + row["varied"].dump() + "\n";
      if (row.contains("target")) {
        out += "       " + row["target"]["text"].get<std::string>() + "\n";
      }
    }
    if (const Json& slurm = status["slurm"]; !slurm.is_null()) {
      out += fmt::format("Slurm{}: {} tasks wait, {} run, {} unknown\n",
                         slurm["answers"].get<bool>() ? "" : " does not answer",
                         slurm["tasks_waiting"].get<long>(),
                         slurm["tasks_running"].get<long>(),
                         slurm["tasks_unknown"].get<long>());
      for (const auto& [why, count] : slurm["reasons"].items()) {
        out += fmt::format("  {} wait: {}\n", count.get<long>(), why);
      }
    }
    if (status["incidents"].get<long>() > 0) {
      out += fmt::format("{} incidents: poreclog query {} incidents\n",
                         status["incidents"].get<long>(),
                         status["campaign"].get<std::string>());
    }
    return out;
  }

  CommonOptions common_;
  std::string campaign_;
  bool watch_ = false;
};

}  // namespace

std::unique_ptr<Command> make_status() {
  return std::make_unique<StatusCommand>();
}

}  // namespace colloid
