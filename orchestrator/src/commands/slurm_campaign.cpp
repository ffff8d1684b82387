#include "commands/slurm_campaign.h"

#include "ingest/ingester.h"

namespace colloid {

SlurmCampaign::SlurmCampaign(const Plan& plan, const RunFolder& folder, Access access)
    : journal_(folder.path(), plan.campaign), jobs_(client_, journal_) {
  access == Access::read_only ? jobs_.ask() : jobs_.refresh();
}

void SlurmCampaign::fold_in(Store& store, const RunFolder& folder, const Plan& plan) {
  Ingester(store, folder, plan, &jobs_).catch_up();
  store.refresh_curves();
  jobs_.close_ended();
}

nlohmann::ordered_json SlurmCampaign::counts() const {
  const SlurmJobs::Counts counts = jobs_.counts();
  return {{"answers", jobs_.answered()},
          {"tasks_waiting", counts.waiting},
          {"tasks_running", counts.running},
          {"tasks_unknown", counts.unknown},
          {"reasons", counts.reasons}};
}

bool has_slurm_jobs(const Plan& plan, const RunFolder& folder) {
  return !SlurmJournal(folder.path(), plan.campaign).open().empty();
}

}  // namespace colloid
