#include "commands/repair.h"

#include <filesystem>
#include <iostream>
#include <list>

#include <fmt/format.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "campaign/run_folder.h"
#include "commands/open_campaign.h"
#include "commands/slurm_campaign.h"
#include "ingest/ingester.h"
#include "store/query.h"
#include "store/store.h"

namespace colloid {

namespace {

namespace fs = std::filesystem;

class Repair : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    app.add_flag("--force", force_,
                 "Also if the old database has results that the run folders have not");
  }

  int run() override {
    const std::string database = absolute(common_.database);
    const std::string part = database + ".repair";
    remove_database(part);
    make_folder(fs::path(database).parent_path().string());
    std::list<FileLock> locks;
    nlohmann::ordered_json campaigns = nlohmann::ordered_json::array();
    for (const std::string& name : campaigns_in(common_.runs)) {
      const RunFolder folder(common_.runs, name);
      auto lock = FileLock::take(folder.lock_file(), "repair\n");
      require(lock.has_value(), folder.path(),
              "a poreclog is at work on this campaign; `poreclog cancel` stops it");
      locks.push_back(std::move(*lock));
      campaigns.push_back(rebuild(part, folder, stored_plan(name, common_)));
    }
    require(!campaigns.empty(), "--runs",
            fmt::format("there is no campaign in {}", common_.runs));
    refuse_losses(database, part);
    const std::string kept = put_in_place(database, part);
    const nlohmann::ordered_json out{
        {"schema_version", 1},
        {"database", database},
        {"old_database",
         kept.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(kept)},
        {"campaigns", campaigns}};
    std::cout << (common_.json ? out.dump(2) + "\n" : text_of(out));
    return exit_done;
  }

 private:
  static void remove_database(const std::string& path) {
    for (const char* suffix : {"", "-wal", "-shm"}) {
      std::error_code ignored;
      fs::remove(path + suffix, ignored);
    }
  }

  static nlohmann::ordered_json rebuild(const std::string& part, const RunFolder& folder,
                                        const Plan& plan) {
    Store store(part, plan, folder.path());
    const auto slurm = has_slurm_jobs(plan, folder)
                           ? std::make_unique<SlurmCampaign>(plan, folder)
                           : nullptr;
    Ingester ingester(store, folder, plan, slurm ? &slurm->jobs() : nullptr);
    const std::size_t running = ingester.catch_up().size();
    store.refresh_curves();
    const std::array<long, 5> counts = store.count();
    return {{"campaign", plan.campaign},
            {"ingested", counts.at(static_cast<std::size_t>(Status::ingested))},
            {"failed", counts.at(static_cast<std::size_t>(Status::failed))},
            {"running", running}};
  }

  /// A result that is only in the old database (its run folder was removed) would go.
  void refuse_losses(const std::string& old, const std::string& fresh) const {
    if (force_ || !fs::exists(old)) {
      return;
    }
    const std::string count =
        "SELECT campaign, count(*) FROM v_realisation WHERE status = 'ingested' "
        "GROUP BY campaign";
    QueryResult before;
    try {
      before = ask(old, count, "");
    } catch (const std::exception&) {
      return;  // it cannot be read: that is what repair is for
    }
    const QueryResult after = ask(fresh, count, "");
    for (const auto& row : before.rows) {
      long now = 0;
      for (const auto& other : after.rows) {
        now = other[0] == row[0] ? other[1].get<long>() : now;
      }
      require(
          now >= row[1].get<long>(), "repair",
          fmt::format("the old database has {} results of campaign {}, the run folders "
                      "have {}: give --force to lose them (the old one is kept)",
                      row[1].get<long>(), row[0].get<std::string>(), now));
    }
  }

  /// Renames the new database over the old one, which is kept under another name.
  static std::string put_in_place(const std::string& database, const std::string& part) {
    std::string kept;
    if (fs::exists(database)) {
      kept = fmt::format("{}.before-{}", database, utc_now());
      for (const char* suffix : {"-wal", "-shm"}) {
        if (fs::exists(database + suffix)) {
          fs::copy_file(database + suffix, kept + suffix);
        }
      }
      fs::copy_file(database, kept);
    }
    for (const char* suffix : {"-wal", "-shm"}) {
      std::error_code ignored;
      fs::remove(database + suffix, ignored);  // they belong to the old one
      fs::remove(part + suffix, ignored);      // empty: the writer has closed it
    }
    fs::rename(part, database);
    return kept;
  }

  static std::string text_of(const nlohmann::ordered_json& out) {
    std::string text;
    for (const auto& c : out["campaigns"]) {
      text += fmt::format("{}: {} ingested, {} failed, {} running\n",
                          c["campaign"].get<std::string>(), c["ingested"].get<long>(),
                          c["failed"].get<long>(), c["running"].get<long>());
    }
    if (!out["old_database"].is_null()) {
      text += "the old database is " + out["old_database"].get<std::string>() + "\n";
    }
    return text;
  }

  CommonOptions common_;
  bool force_ = false;
};

}  // namespace

std::unique_ptr<Command> make_repair() {
  return std::make_unique<Repair>();
}

}  // namespace colloid
