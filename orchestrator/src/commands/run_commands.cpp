#include "commands/run_commands.h"

#include <algorithm>
#include <iostream>
#include <thread>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"
#include "base/signals.h"
#include "commands/campaign_lock.h"
#include "commands/campaign_run.h"
#include "commands/dry_run.h"
#include "commands/open_campaign.h"
#include "commands/slurm_campaign.h"
#include "commands/write_report.h"
#include "execute/local_executor.h"
#include "execute/slurm_executor.h"

namespace colloid {

namespace {

int workers_of(const Plan& plan) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return plan.limits.workers > 0 ? plan.limits.workers : std::max(1, cores / plan.ranks);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of each design point and tier; null without a target.
nlohmann::ordered_json targets_json(const Plan& plan, const TargetWatch& target) {
  if (!target.has_target()) {
    return nullptr;
  }
  auto out = nlohmann::ordered_json::array();
  for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
    out.push_back({{"point", plan.ensembles[e].point}, {"tier", plan.ensembles[e].tier}});
    out.back().update(target.json(e));
  }
  return out;
}

/// Realisations that a met target makes superfluous.
long not_needed(const Plan& plan, const Store& store, const TargetWatch& target) {
  long count = 0;
  for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
    for (int i = target.wanted(e); target.has_target() && i < plan.realisations; ++i) {
      count += target.state(e).met && store.status({e, i}) == Status::eligible ? 1 : 0;
    }
  }
  return count;
}

nlohmann::ordered_json outcome_json(const Plan& plan, const RunFolder& folder,
                                    Store& store, int exit_code, const std::string& why,
                                    const TargetWatch& target) {
  nlohmann::ordered_json out{{"schema_version", 1}, {"campaign", plan.campaign}};
  const std::array<long, 5> counts = store.count();
  out["realisations"] = static_cast<long>(plan.ensembles.size()) * plan.realisations;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    out[name_of(static_cast<Status>(i))] = counts.at(i);
  }
  out["contradictions"] = store.contradictions();
  out["not_needed"] = not_needed(plan, store, target);
  out["targets"] = targets_json(plan, target);
  out["stopped"] = why.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(why);
  rusage own{};
  ::getrusage(RUSAGE_SELF, &own);
  out["orchestrator_cpu_s"] = seconds(own.ru_utime) + seconds(own.ru_stime);
  out["orchestrator_memory_kB"] = own.ru_maxrss;
  out["database"] = store.database().path();
  out["run_folder"] = folder.path();
  out["exit_code"] = exit_code;
  return out;
}

std::string outcome_text(const nlohmann::ordered_json& outcome) {
  std::string text = fmt::format(
      "{}: {} of {} realisations ingested", outcome["campaign"].get<std::string>(),
      outcome["ingested"].get<long>(), outcome["realisations"].get<long>());
  for (const char* key : {"failed", "active", "eligible", "unknown", "contradictions"}) {
    const long spared =
        key == std::string("eligible") ? outcome["not_needed"].get<long>() : 0;
    if (outcome[key].get<long>() > spared) {
      text += fmt::format(", {} {}", outcome[key].get<long>() - spared, key);
    }
  }
  if (outcome["not_needed"].get<long>() > 0) {
    text += fmt::format(", {} not needed", outcome["not_needed"].get<long>());
  }
  if (outcome.contains("slurm") && outcome["active"].get<long>() > 0) {
    text += fmt::format("; on Slurm {} tasks wait, {} run",
                        outcome["slurm"]["tasks_waiting"].get<long>(),
                        outcome["slurm"]["tasks_running"].get<long>());
  }
  if (!outcome["stopped"].is_null()) {
    text += "; " + outcome["stopped"].get<std::string>();
    if (outcome["exit_code"] == exit_interrupted) {
      text += fmt::format("; `poreclog resume {}` goes on",
                          outcome["campaign"].get<std::string>());
    }
  }
  return text + "\n";
}

/// Where the targets stand; the headlines of a report say it too.
std::string targets_text(const nlohmann::ordered_json& outcome) {
  std::string text;
  for (const auto& target : outcome["targets"]) {
    text +=
        fmt::format("design point {}, tier {}: {}\n", target["point"].get<int>(),
                    target["tier"].get<std::string>(), target["text"].get<std::string>());
  }
  return text;
}

long left_to_run(const Plan& plan, const Store& store) {
  const std::array<long, 5> counts = store.count();
  return static_cast<long>(plan.ensembles.size()) * plan.realisations -
         counts.at(static_cast<std::size_t>(Status::ingested)) -
         counts.at(static_cast<std::size_t>(Status::failed));
}

/// The one place where it is decided what runs a campaign's attempts.  `slurm`: null if
/// nothing of the campaign is or goes there.
std::unique_ptr<Executor> make_executor(const Plan& plan, const Store& store,
                                        SlurmCampaign* slurm) {
  if (slurm == nullptr) {
    return std::make_unique<LocalExecutor>(workers_of(plan), find_keeper());
  }
  return std::make_unique<SlurmExecutor>(plan, slurm->client(), slurm->journal(),
                                         slurm->jobs(), find_keeper(),
                                         left_to_run(plan, store));
}

/// What these commands have in common: from a plan to its realisations' ends.
class WorkCommand : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    app.add_option("campaign", campaign_, campaign_help())->required();
    app.add_option("--workers", workers_,
                   "Realisations at once (default: the campaign's)")
        ->envname("PORECLOG_WORKERS")
        ->check(CLI::Range(1, 4096));
    app.add_option("--executor", executor_,
                   "Where realisations run: local or slurm (default: the campaign's)")
        ->envname("PORECLOG_EXECUTOR")
        ->check(CLI::IsMember({"local", "slurm"}));
    app.add_flag("--wait", wait_, "With Slurm: stay until all realisations have ended");
    app.add_option("--output", output_,
                   "Folder for report.html and statistics.json (default: "
                   "results/reports/<campaign>)")
        ->envname("PORECLOG_OUTPUT");
    app.add_flag("--no-report", no_report_, "Leave no report at the end")
        ->envname("PORECLOG_NO_REPORT");
    declare_more(app);
  }

  int run() override {
    const Signals signals;
    OpenedCampaign opened = open_campaign(campaign_, common_);
    Plan& plan = opened.plan;
    change(opened);
    if (!executor_.empty()) {
      plan.executor = executor_;
    }
    if (workers_ > 0) {
      plan.limits.workers = workers_;
    }
    const RunFolder folder(common_.runs, plan.campaign);
    const bool to_slurm = plan.executor == "slurm";
    require(to_slurm || !has_slurm_jobs(plan, folder), "--executor",
            "is local, but jobs of this campaign are on Slurm: go on with --executor "
            "slurm, or `poreclog cancel` them first");
    if (dry_run_) {
      const nlohmann::ordered_json answer = dry_run(plan, common_);
      std::cout << (common_.json ? answer.dump(2) + "\n" : dry_run_text(answer));
      return exit_done;
    }
    const SolverProgram solver = SolverProgram::find(common_.solver);
    solver.require_for(plan);
    const std::string database = absolute(common_.database);
    make_places(folder, database);
    const FileLock lock = lock_campaign(folder);
    folder.write_plan(plan);
    Store store(database, plan, folder.path());
    prepare(plan, store, folder);
    const auto slurm = to_slurm ? std::make_unique<SlurmCampaign>(plan, folder) : nullptr;
    const std::unique_ptr<Executor> executor = make_executor(plan, store, slurm.get());
    CampaignRun campaign(plan, folder, solver, store, *executor, signals,
                         slurm ? &slurm->jobs() : nullptr);
    int exit_code = 0;
    if (to_slurm && !wait_ && !waits_for_slurm()) {
      exit_code = left_with_slurm(campaign.launch(), store);
      slurm->jobs().close_ended();
    } else {
      exit_code = campaign.run();
    }
    auto outcome = outcome_json(plan, folder, store, exit_code, campaign.why_stopped(),
                                campaign.target());
    if (slurm) {
      outcome["slurm"] = slurm->counts();
    }
    std::string text = outcome_text(outcome);
    const bool has_ended = campaign.has_ended() && outcome["active"].get<long>() == 0;
    if (has_ended && !no_report_ && outcome["ingested"].get<long>() > 0) {
      const WrittenReport report = write_report(plan, common_, output_);
      outcome["report"] = report.page;
      text += report.headlines + "report: " + report.page + "\n";
    } else {
      text += targets_text(outcome);
    }
    std::cout << (common_.json ? outcome.dump(2) + "\n" : text);
    return exit_code;
  }

 protected:
  virtual const char* campaign_help() const {
    return "A campaign file, or the name of a campaign that has been run";
  }
  virtual void declare_more(CLI::App&) {}
  /// Changes the plan before it is stored.
  virtual void change(OpenedCampaign&) {}
  /// Changes the standing of realisations before the run.
  virtual void prepare(const Plan&, Store&, const RunFolder&) {}

  /// Does the command stay until a campaign's jobs on Slurm have ended?
  virtual bool waits_for_slurm() const { return false; }
  /// The ExitCode if it does not stay, and would have returned `exit_code`.
  virtual int left_with_slurm(int exit_code, const Store&) const { return exit_code; }

  const CommonOptions& common() const { return common_; }
  void choose_executor(const std::string& name) { executor_ = name; }
  void declare_dry_run(CLI::App& app) {
    app.add_flag("--dry-run", dry_run_,
                 "Print what would be run and why, and for Slurm the command and the "
                 "script; run and write nothing");
  }

 private:
  /// A place that cannot be written to is refused: nothing has begun yet.
  static void make_places(const RunFolder& folder, const std::string& database) {
    try {
      make_folder(folder.path());
      make_folder(database.substr(0, database.rfind('/')));
      write_whole(folder.path() + "/writable", "", false);
    } catch (const StorageError& error) {
      throw InputError("--runs, --database", error.what());
    }
    ::unlink((folder.path() + "/writable").c_str());
  }

  CommonOptions common_;
  std::string campaign_;
  std::string output_;
  std::string executor_;
  bool no_report_ = false;
  bool wait_ = false;
  bool dry_run_ = false;
  int workers_ = 0;
};

class Run : public WorkCommand {
 protected:
  void declare_more(CLI::App& app) override { declare_dry_run(app); }
  bool waits_for_slurm() const override { return true; }
};

/// Hands a campaign to Slurm, whatever executor it names.
class Submit : public WorkCommand {
 protected:
  void declare_more(CLI::App& app) override { declare_dry_run(app); }
  void change(OpenedCampaign&) override { choose_executor("slurm"); }
  int left_with_slurm(int exit_code, const Store& store) const override {
    const std::array<long, 5> counts = store.count();
    const bool all_sent = counts.at(static_cast<std::size_t>(Status::eligible)) == 0 &&
                          counts.at(static_cast<std::size_t>(Status::unknown)) == 0;
    return exit_code == exit_stopped && all_sent ? exit_done : exit_code;
  }
};

class Resume : public WorkCommand {
 protected:
  void declare_more(CLI::App& app) override { declare_dry_run(app); }
  void change(OpenedCampaign& opened) override {
    require(opened.exists, "campaign",
            fmt::format("{} has not been run with --runs {}: there is nothing to resume; "
                        "`poreclog run` begins it",
                        opened.plan.campaign, common().runs));
    // It goes on where it was, whatever its file says; --executor moves it.
    const auto stored = RunFolder(common().runs, opened.plan.campaign).read_plan();
    opened.plan.executor = stored ? stored->executor : opened.plan.executor;
  }
};

/// Gives failed realisations all their attempts again.
class Retry : public Resume {
 protected:
  void declare_more(CLI::App& app) override {
    app.add_flag("--failed", failed_, "Those that failed (the default)");
    app.add_flag(
        "--unknown", unknown_,
        "Those that were begun on another machine and are known to have stopped");
  }
  void prepare(const Plan& plan, Store& store, const RunFolder& folder) override {
    for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
      for (int index = 0; index < plan.realisations; ++index) {
        const Item item{e, index};
        const Status status = store.status(item);
        const std::string realisation = folder.realisation(plan, item);
        if (status == Status::unknown && unknown_) {
          give_up_unknown(realisation);
        } else if (status == Status::failed && (failed_ || !unknown_)) {
          const std::vector<int> attempts = attempts_in(realisation);
          store.forgive(item, attempts.empty() ? 0 : attempts.back());
        }
      }
    }
  }

 private:
  /// The user says that it does not run: an ending says so to the ingester.
  static void give_up_unknown(const std::string& realisation) {
    for (const int number : attempts_in(realisation)) {
      const std::string ending = attempt_folder(realisation, number) + "/ending.json";
      if (!read_if_there(ending)) {
        write_whole(ending, "{\"schema_version\": 1, \"lost\": true}\n", false);
      }
    }
  }

  bool failed_ = false;
  bool unknown_ = false;
};

/// More realisations of every design point; those that exist stay as they are.
class Extend : public Resume {
 protected:
  void declare_more(CLI::App& app) override {
    declare_dry_run(app);
    auto* size = app.add_option_group("size", "Exactly one:");
    size->add_option("--by", by_, "So many more of each design point")
        ->check(CLI::Range(1, 10'000'000));
    size->add_option("--to", to_, "So many of each design point in all")
        ->check(CLI::Range(1, 10'000'000));
    size->require_option(1);
  }
  void change(OpenedCampaign& opened) override {
    Resume::change(opened);
    const int now = opened.plan.realisations;
    require(to_ == 0 || to_ >= now, "--to",
            fmt::format("is {}, but there are {} already: an ensemble does not shrink",
                        to_, now));
    opened.plan.realisations = std::min(10'000'000, to_ > 0 ? to_ : now + by_);
  }

 private:
  int by_ = 0;
  int to_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_run() {
  return std::make_unique<Run>();
}
std::unique_ptr<Command> make_submit() {
  return std::make_unique<Submit>();
}
std::unique_ptr<Command> make_resume() {
  return std::make_unique<Resume>();
}
std::unique_ptr<Command> make_retry() {
  return std::make_unique<Retry>();
}
std::unique_ptr<Command> make_extend() {
  return std::make_unique<Extend>();
}

}  // namespace colloid
