#include "commands/slurm_plan.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "execute/local_executor.h"
#include "execute/slurm_client.h"
#include "execute/slurm_journal.h"
#include "execute/slurm_layout.h"

namespace colloid {

using Json = nlohmann::ordered_json;

Json slurm_plan(const Plan& plan, const RunFolder& folder, const SlurmClient& client,
                long realisations) {
  const SlurmLimits limits = client.limits(plan.slurm.partition);
  const SlurmLayout layout = slurm_layout(plan, limits, realisations);
  const Submission next = SlurmJournal(folder.path(), plan.campaign).next();
  const long now = std::min(realisations, layout.tasks * layout.per_task);
  const long per_array = layout.array_tasks * layout.per_task;
  const long first = std::min(now, per_array);
  std::vector<std::string> words{"sbatch", "--parsable"};
  const std::vector<std::string> more =
      sbatch_words(plan, layout, next.name, next.folder,
                   (first + layout.per_task - 1) / layout.per_task);
  words.insert(words.end(), more.begin(), more.end());
  return {{"max_array_size", limits.array_size},
          {"max_job_count", limits.job_count},
          {"max_time_s", limits.seconds},
          {"sbatch_calls", (now + per_array - 1) / per_array},
          {"realisations", now},
          {"per_task", layout.per_task},
          {"minutes", layout.minutes},
          {"reasons", layout.reasons},
          {"command", words},
          {"script_file", next.folder + "/script"},
          {"script", batch_script(plan, layout, next.folder, find_keeper())}};
}

std::string slurm_plan_text(const Json& planned) {
  const long calls = planned["sbatch_calls"].get<long>();
  std::string text = fmt::format("{} call{} of sbatch\n", calls, calls == 1 ? "" : "s");
  for (const Json& why : planned["reasons"]) {
    text += "  " + why.get<std::string>() + "\n";
  }
  if (calls > 0) {
    text += fmt::format("the first:\n\n{}\n\n{}:\n\n{}",
                        command_line(planned["command"].get<std::vector<std::string>>()),
                        planned["script_file"].get<std::string>(),
                        planned["script"].get<std::string>());
  }
  return text;
}

}  // namespace colloid
