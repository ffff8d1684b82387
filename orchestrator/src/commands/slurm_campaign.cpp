#include "commands/slurm_campaign.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "execute/slurm_layout.h"
#include "ingest/ingester.h"

namespace colloid {

SlurmCampaign::SlurmCampaign(const Plan& plan, const RunFolder& folder)
    : journal_(folder.path(), plan.campaign), jobs_(client_, journal_) {
  jobs_.refresh();
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

SlurmPlan slurm_plan(const Plan& plan, const RunFolder& folder, const std::string& keeper,
                     long realisations) {
  const SlurmClient client;
  const SlurmLimits limits = client.limits(plan.slurm.partition);
  const SlurmLayout layout = slurm_layout(plan, limits, realisations);
  const Submission next = SlurmJournal(folder.path(), plan.campaign).next();
  const long now = std::min(realisations, layout.tasks * layout.per_task);
  const long per_array = layout.array_tasks * layout.per_task;
  const long arrays = (now + per_array - 1) / per_array;
  const long first = std::min(now, per_array);
  std::vector<std::string> words{"sbatch", "--parsable"};
  const std::vector<std::string> more =
      sbatch_words(plan, layout, next.name, next.folder,
                   (first + layout.per_task - 1) / layout.per_task);
  words.insert(words.end(), more.begin(), more.end());
  const std::string script = batch_script(plan, layout, next.folder, keeper);
  SlurmPlan out;
  out.json = {{"max_array_size", limits.array_size},
              {"max_job_count", limits.job_count},
              {"max_time_s", limits.seconds},
              {"sbatch_calls", arrays},
              {"realisations", now},
              {"per_task", layout.per_task},
              {"minutes", layout.minutes},
              {"reasons", layout.reasons},
              {"command", words},
              {"script", script}};
  out.text = fmt::format("{} call{} of sbatch\n", arrays, arrays == 1 ? "" : "s");
  for (const std::string& why : layout.reasons) {
    out.text += "  " + why + "\n";
  }
  if (arrays > 0) {
    out.text += fmt::format("the first:\n\n{}\n\n{}/script:\n\n{}", command_line(words),
                            next.folder, script);
  }
  return out;
}

bool has_slurm_jobs(const Plan& plan, const RunFolder& folder) {
  return !SlurmJournal(folder.path(), plan.campaign).open().empty();
}

}  // namespace colloid
