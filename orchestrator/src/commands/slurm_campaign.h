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
  enum class Access { read_only, read_write };
  /// Reads the journal and asks Slurm, if there is something to ask for.
  SlurmCampaign(const Plan& plan, const RunFolder& folder,
                Access access = Access::read_write);

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

/// Has something been sent to Slurm that is not known to have ended?
bool has_slurm_jobs(const Plan& plan, const RunFolder& folder);

}  // namespace colloid
