#include "commands/cancel.h"

#include <csignal>
#include <iostream>

#include <fmt/format.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "base/signals.h"
#include "campaign/run_folder.h"
#include "commands/campaign_lock.h"
#include "commands/open_campaign.h"
#include "commands/slurm_campaign.h"
#include "execute/local_executor.h"

namespace colloid {

namespace {

constexpr double kPatience = 60.0;  // [s] for Slurm to end jobs

class Cancel : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    add_campaign_option(app, campaign_);
    app.add_flag("--now", now_,
                 "Kill the realisations instead of letting them write "
                 "checkpoints");
  }

  int run() override {
    const Signals signals;
    const Plan plan = stored_plan(campaign_name(campaign_), common_);
    const RunFolder folder(common_.runs, plan.campaign);
    bool was_running = false;
    if (FileLock::is_held(folder.lock_file())) {
      was_running = true;
      const Keeper holder = holder_of(folder.lock_file());
      require(holder.host == host_name(), "cancel",
              fmt::format("the campaign is run by process {} on {}: cancel it there",
                          holder.process, holder.host));
      ::kill(holder.process, SIGTERM);
      if (now_) {
        signals.wait(0.2);
        ::kill(holder.process, SIGTERM);
      }
      wait_until_free(signals, plan, folder.lock_file());
    }
    const long jobs = has_slurm_jobs(plan, folder) ? stop_jobs(signals, plan, folder) : 0;
    const long orphans = stop_orphans(plan, folder);
    const nlohmann::ordered_json out{{"schema_version", 1},
                                     {"campaign", plan.campaign},
                                     {"was_running", was_running},
                                     {"orphans_stopped", orphans},
                                     {"tasks_stopped", jobs}};
    std::cout << (common_.json ? out.dump(2) + "\n"
                  : was_running || orphans > 0 || jobs > 0
                      ? fmt::format("{}: stopped; `poreclog resume {}` goes on\n",
                                    plan.campaign, plan.campaign)
                      : fmt::format("{}: nothing is running\n", plan.campaign));
    return exit_done;
  }

 private:
  static Keeper holder_of(const std::string& lock_file) {
    std::istringstream text(read_if_there(lock_file).value_or(""));
    Keeper holder;
    text >> holder.process >> holder.host;
    require(holder.process > 1, lock_file, "does not say who holds it");
    return holder;
  }

  static void wait_until_free(const Signals& signals, const Plan& plan,
                              const std::string& lock_file) {
    const double patience = monotonic_seconds() + plan.limits.seconds_to_stop + 10.0;
    while (FileLock::is_held(lock_file)) {
      if (monotonic_seconds() > patience || signals.wait(0.1) == Signals::Event::stop) {
        throw StorageError(lock_file + " is still held: it has not stopped");
      }
    }
  }

  /// Ends the campaign's jobs on Slurm, and waits until nothing of them runs.  Returns
  /// how many tasks there were.
  long stop_jobs(const Signals& signals, const Plan& plan,
                 const RunFolder& folder) const {
    const FileLock lock = lock_campaign(folder);
    SlurmCampaign slurm(plan, folder);
    const SlurmJobs::Counts before = slurm.jobs().counts();
    const double patience = monotonic_seconds() + plan.limits.seconds_to_stop + kPatience;
    slurm.jobs().cancel(now_ ? Stop::at_once : Stop::politely);
    for (SlurmJobs::Counts left = before;
         !slurm.jobs().answered() || left.waiting + left.running + left.unknown > 0;) {
      if (monotonic_seconds() > patience || signals.wait(0.5) == Signals::Event::stop) {
        throw StorageError(fmt::format(
            "{} tasks are still with Slurm{}; `poreclog cancel` again goes on",
            left.waiting + left.running + left.unknown,
            slurm.jobs().answered() ? "" : ", which does not answer"));
      }
      slurm.jobs().refresh();
      slurm.jobs().cancel(Stop::politely);  // also what the answer was lost of
      left = slurm.jobs().counts();
    }
    Store store(absolute(common_.database), plan, folder.path());
    slurm.fold_in(store, folder, plan);
    return before.waiting + before.running + before.unknown;
  }

  /// Attempts that a killed orchestrator left running.
  long stop_orphans(const Plan& plan, const RunFolder& folder) const {
    long count = 0;
    for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
      for (const int index : folder.started(plan.ensembles[e])) {
        const std::string realisation = folder.realisation(plan, {e, index});
        const std::vector<int> attempts = attempts_in(realisation);
        const std::string last =
            attempts.empty() ? "" : attempt_folder(realisation, attempts.back());
        if (last.empty() || !is_running(last)) {
          continue;
        }
        const Keeper keeper = keeper_of(last);
        if (keeper.process > 1 && keeper.host == host_name()) {
          ::kill(keeper.process, now_ ? SIGQUIT : SIGTERM);
          ++count;
        }
      }
    }
    return count;
  }

  CommonOptions common_;
  std::string campaign_;
  bool now_ = false;
};

}  // namespace

std::unique_ptr<Command> make_cancel() {
  return std::make_unique<Cancel>();
}

}  // namespace colloid
