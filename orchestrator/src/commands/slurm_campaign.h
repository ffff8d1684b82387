// The part of a campaign that is with Slurm, as the commands need it.
#pragma once

#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "campaign/run_folder.h"
#include "execute/slurm_jobs.h"
#include "store/store.h"

namespace colloid {

/// Client, journal and jobs of one campaign.
class SlurmCampaign {
 public:
  /// Reads the journal and asks Slurm, if there is something to ask for.
  SlurmCampaign(const Plan& plan, const RunFolder& folder);

  const SlurmClient& client() const { return client_; }
  const SlurmJournal& journal() const { return journal_; }
  SlurmJobs& jobs() { return jobs_; }

  /// Brings the database up to what the jobs have left, while others may still run.
  void fold_in(Store& store, const RunFolder& folder, const Plan& plan);

  /// Where the tasks are.
  nlohmann::ordered_json counts() const;

 private:
  SlurmClient client_;
  SlurmJournal journal_;
  SlurmJobs jobs_;
};

/// What would be sent to Slurm for so many realisations: the limits that were read, the
/// layout and its reasons, the first command and its script.
struct SlurmPlan {
  nlohmann::ordered_json json;
  std::string text;
};
SlurmPlan slurm_plan(const Plan& plan, const RunFolder& folder, const std::string& keeper,
                     long realisations);

/// Has something been sent to Slurm that is not known to have ended?
bool has_slurm_jobs(const Plan& plan, const RunFolder& folder);

}  // namespace colloid
