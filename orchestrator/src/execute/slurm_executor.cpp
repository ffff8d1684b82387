#include "execute/slurm_executor.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/files.h"
#include "execute/local_executor.h"

namespace colloid {

namespace {

// Between two questions lie twenty times what the answer took: at most a twentieth of one
// connection to the controller, whatever its load.
constexpr double kPausesPerAnswer = 20.0;
constexpr double kShortestPace = 1.0;  // [s]
constexpr double kLongestPace = 60.0;  // [s]

/// Here and not by the jobs: what has a folder is known, though no job ever comes to it.
void make_attempt(const Job& job) {
  claim_folder(std::filesystem::path(job.folder).parent_path().string());
  if (!claim_folder(job.folder)) {
    throw StorageError(job.folder + ": somebody else has begun this attempt");
  }
  write_new(job.folder + "/command", job.command_line + "\n");
}

}  // namespace

SlurmExecutor::SlurmExecutor(const Plan& plan, const SlurmClient& client,
                             const SlurmJournal& journal, SlurmJobs& jobs,
                             std::string keeper, long realisations)
    : plan_(plan),
      client_(client),
      journal_(journal),
      jobs_(jobs),
      keeper_(std::move(keeper)),
      layout_(slurm_layout(plan, client.limits(plan.slurm.partition), realisations)) {}

std::size_t SlurmExecutor::free_slots() const {
  if (!refusal_.empty() || (!sending_ && !running_.empty()) || !jobs_.answered()) {
    return 0;
  }
  const SlurmJobs::Counts now = jobs_.counts();
  const long left = layout_.tasks - now.waiting - now.running - now.unknown;
  return static_cast<std::size_t>(std::clamp(left, 0L, layout_.array_tasks) *
                                  layout_.per_task);
}

void SlurmExecutor::submit(const std::vector<Job>& jobs) {
  Submission submission = journal_.next();
  submission.per_task = layout_.per_task;
  submission.attempts.reserve(jobs.size());
  for (const Job& job : jobs) {
    require(job.folder.find('\n') == std::string::npos, "--runs",
            "has a line break in its name, which job arrays cannot take");
    make_attempt(job);
    submission.attempts.push_back(job.folder);
    running_[job.id] = job.folder;
  }
  const long tasks =
      (static_cast<long>(jobs.size()) + layout_.per_task - 1) / layout_.per_task;
  journal_.begin(submission, batch_script(plan_, layout_, submission.folder, keeper_));
  const SlurmClient::Submitted answer = client_.submit(
      sbatch_words(plan_, layout_, submission.name, submission.folder, tasks));
  if (answer.job) {
    journal_.accept(submission, *answer.job);
    jobs_.add(std::move(submission));
    has_sent_ = true;
    return;
  }
  // Refused, or accepted and the answer lost: the name tells, now or at the next poll.
  const std::size_t at = jobs_.add(std::move(submission));
  jobs_.refresh();
  if (!jobs_.answered()) {
    throw StorageError(fmt::format(
        "sbatch gave no job ({}) and Slurm does not answer; `poreclog resume` finds out "
        "whether it was accepted",
        answer.message));
  }
  if (jobs_.has_job(at)) {
    has_sent_ = true;
    return;
  }
  refusal_ = "sbatch: " + answer.message;
  require(has_sent_, "sbatch", answer.message);
}

bool SlurmExecutor::adopt(const Job& job) {
  running_[job.id] = job.folder;
  return true;
}

std::vector<std::int64_t> SlurmExecutor::poll() {
  const double begin = monotonic_seconds();
  sending_ = false;
  jobs_.refresh();
  pace_ = std::clamp(kPausesPerAnswer * (monotonic_seconds() - begin), kShortestPace,
                     kLongestPace);
  std::vector<std::int64_t> ended;
  for (const auto& [id, folder] : running_) {
    const Presence presence = jobs_.conclude(folder);
    if (presence == Presence::ended ||
        (presence == Presence::not_mine && !is_running(folder))) {
      ended.push_back(id);
    }
  }
  for (const std::int64_t id : ended) {
    running_.erase(id);
  }
  jobs_.close_ended();
  if (running_.empty()) {  // another round
    refusal_.clear();
    has_sent_ = false;
  }
  return ended;
}

void SlurmExecutor::cancel(Stop how) {
  jobs_.cancel(how);
}

}  // namespace colloid
