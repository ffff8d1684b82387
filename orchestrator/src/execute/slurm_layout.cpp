#include "execute/slurm_layout.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "array_task_sh.h"
#include "base/error.h"
#include "base/text.h"

namespace colloid {

namespace {

constexpr long kPerSubmission = 1000;     // realisations, at least
constexpr double kSlackPerAttempt = 5.0;  // [s] start, and writing the result
constexpr double kSlackPerTask = 60.0;    // [s] for Slurm
constexpr double kLongestMinutes = 5.0e6;

constexpr long ceil_div(long a, long b) {
  return (a + b - 1) / b;
}

double seconds_per_attempt(const Plan& plan) {
  return plan.limits.seconds_per_realisation + plan.limits.seconds_to_stop +
         kSlackPerAttempt;
}

}  // namespace

SlurmLayout slurm_layout(const Plan& plan, const SlurmLimits& limits, long realisations) {
  SlurmLayout layout;
  std::vector<std::string>& why = layout.reasons;
  const long table = std::max(1L, limits.job_count / 2);
  const long arrays_at_once = plan.limits.workers > 0 ? plan.limits.workers : table;
  layout.array_tasks = std::min({limits.array_size, table, kPerSubmission});
  layout.tasks =
      layout.array_tasks * std::min(arrays_at_once, table / layout.array_tasks);
  const double each = seconds_per_attempt(plan);
  const long fits =
      limits.seconds > 0.0
          ? std::max(0L, static_cast<long>((limits.seconds - kSlackPerTask) / each))
          : realisations;
  require(fits > 0 || realisations == 0, "/limits/seconds_per_realisation",
          fmt::format("and the time to stop are {} together, but the partition's jobs "
                      "have {} (MaxTime)",
                      duration_text(each), duration_text(limits.seconds)));
  const long wanted =
      std::max(ceil_div(realisations, layout.tasks),
               ceil_div(std::min(realisations, kPerSubmission), layout.array_tasks));
  const int given = plan.slurm.realisations_per_task;
  if (given > 0) {
    require(
        given <= fits, "/slurm/realisations_per_task",
        fmt::format("is {}, but only {} fit into the partition's MaxTime", given, fits));
    layout.per_task = given;
    why.push_back(fmt::format("{} realisations per task, as the campaign says", given));
  } else {
    layout.per_task = std::max(1L, std::min({wanted, fits, realisations}));
    why.push_back(fmt::format(
        "{} realisation{} per task: half of MaxJobCount = {} and MaxArraySize = {} give "
        "{} tasks in arrays of {} for {} realisations{}",
        layout.per_task, layout.per_task > 1 ? "s one after another" : "",
        limits.job_count, limits.array_size, layout.tasks, layout.array_tasks,
        realisations,
        layout.per_task < wanted && layout.per_task < realisations
            ? fmt::format("; {} would be needed, MaxTime allows {}", wanted, fits)
            : ""));
  }
  if (layout.per_task * layout.tasks < realisations) {
    why.push_back(fmt::format("{} realisations wait for a later `poreclog resume`",
                              realisations - layout.per_task * layout.tasks));
  }
  const long arrays =
      std::max(1L, std::min(ceil_div(realisations, layout.per_task * layout.array_tasks),
                            layout.tasks / layout.array_tasks));
  if (plan.limits.workers > 0) {
    layout.at_once = static_cast<int>(std::max(1L, plan.limits.workers / arrays));
    why.push_back(fmt::format("{} tasks of each array at once: workers = {}, {} array{}",
                              layout.at_once, plan.limits.workers, arrays,
                              arrays > 1 ? "s" : ""));
  }
  const double minutes =
      std::ceil((static_cast<double>(layout.per_task) * each + kSlackPerTask) / 60.0);
  layout.minutes = static_cast<long>(std::min(minutes, kLongestMinutes));
  why.push_back(fmt::format(
      "time limit {} min: {} x {:.6g} s (limit, time to stop, {:g} s), and {:g} s; the "
      "limit itself is kept within the task",
      layout.minutes, layout.per_task, each, kSlackPerAttempt, kSlackPerTask));
  return layout;
}

std::vector<std::string> sbatch_words(const Plan& plan, const SlurmLayout& layout,
                                      const std::string& name, const std::string& folder,
                                      long tasks) {
  // Slurm replaces %-signs and backslashes in the output's name, the folder's too.
  const bool is_plain = folder.find_first_of("%\\") == std::string::npos;
  std::vector<std::string> words{
      "--job-name=" + name,
      fmt::format("--array=0-{}{}", tasks - 1,
                  layout.at_once > 0 ? fmt::format("%{}", layout.at_once) : ""),
      "--chdir=" + folder,
      is_plain ? "--output=output" : "--output=/dev/null",
      "--open-mode=append",
      "--export=ALL",
      "--requeue",
      fmt::format("--ntasks={}", plan.ranks),
      fmt::format("--time={}", layout.minutes)};
  if (!plan.slurm.partition.empty()) {
    words.push_back("--partition=" + plan.slurm.partition);
  }
  if (!plan.slurm.account.empty()) {
    words.push_back("--account=" + plan.slurm.account);
  }
  if (plan.slurm.memory_MiB > 0) {
    words.push_back(
        fmt::format("--mem-per-cpu={}M", ceil_div(plan.slurm.memory_MiB, plan.ranks)));
  }
  words.insert(words.end(), plan.slurm.options.begin(), plan.slurm.options.end());
  words.push_back(folder + "/script");
  return words;
}

std::string batch_script(const Plan& plan, const SlurmLayout& layout,
                         const std::string& folder, const std::string& keeper) {
  return fmt::format(
      "#!/bin/sh\n"
      "# Written by poreclog.  Task n of the array runs {0} line{1} of the list, from\n"
      "# line n*{0}+1, one after another: each is the folder of an attempt.\n"
      "list={2}\nkeeper={3}\nper_task={0}\nseconds={4}\nseconds_to_stop={5}\n\n{6}",
      layout.per_task, layout.per_task > 1 ? "s" : "", shell_quoted(folder + "/list"),
      shell_quoted(keeper), plan.limits.seconds_per_realisation,
      plan.limits.seconds_to_stop, kArrayTaskSh);
}

}  // namespace colloid
