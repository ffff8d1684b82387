#include "execute/slurm_jobs.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/file_lock.h"
#include "base/files.h"
#include "execute/slurm_ending.h"

namespace colloid {

namespace {

using nlohmann::json;

std::string parent_of(const std::string& folder) {
  return folder.substr(0, folder.rfind('/'));
}

/// An attempt that was asked to stop, by a task that is still there, may be gone on with
/// by that task: Slurm stops a job also to begin it again.
bool was_asked_to_stop(const std::string& ending) {
  const json parsed = json::parse(ending, nullptr, false);
  return parsed.is_object() && parsed.value("stopped", json()) == "asked";
}

/// Makes a file server's client look again for files that it believes absent.
void look_again(const std::string& folder) {
  std::error_code ignored;
  const std::filesystem::directory_iterator first(folder, ignored);
}

}  // namespace

SlurmJobs::SlurmJobs(const SlurmClient& client, const SlurmJournal& journal)
    : client_(client), journal_(journal) {
  for (Submission& submission : journal_.open()) {
    add(std::move(submission));
  }
}

std::size_t SlurmJobs::add(Submission submission) {
  Known known;
  const auto lines = static_cast<long>(submission.attempts.size());
  const long tasks = (lines + submission.per_task - 1) / submission.per_task;
  known.tasks.resize(static_cast<std::size_t>(tasks));
  if (submission.job) {
    known.jobs.push_back(*submission.job);
    for (Task& task : known.tasks) {
      task.state = State::waiting;
    }
  }
  known.submission = std::move(submission);
  submissions_.push_back(std::move(known));
  remember(submissions_.size() - 1);
  return submissions_.size() - 1;
}

void SlurmJobs::remember(std::size_t submission) {
  const Submission& sent = submissions_[submission].submission;
  for (std::size_t line = 0; line < sent.attempts.size(); ++line) {
    const Place place{submission, line / static_cast<std::size_t>(sent.per_task)};
    attempts_[sent.attempts[line]] = place;
    realisations_[parent_of(sent.attempts[line])].push_back(place);
  }
}

void SlurmJobs::ask() {
  if (submissions_.empty()) {
    answered_ = true;
    return;
  }
  const auto listed = client_.tasks();
  answered_ = listed.has_value();
  std::unordered_map<std::string, std::vector<SlurmTask>> by_name;
  if (listed) {
    for (const SlurmTask& task : *listed) {
      by_name[task.name].push_back(task);
    }
  }
  for (Known& known : submissions_) {
    if (!listed) {
      for (Task& task : known.tasks) {
        task = {};
      }
    } else {
      update(known, by_name[known.submission.name]);
    }
  }
}

void SlurmJobs::refresh() {
  ask();
  for (Known& known : submissions_) {
    if (!known.submission.job && !known.jobs.empty()) {
      journal_.accept(known.submission, known.jobs.front());
    }
  }
}

void SlurmJobs::update(Known& known, const std::vector<SlurmTask>& listed) const {
  Task absent{State::ended, "", ""};
  if (listed.empty()) {
    if (known.jobs.empty()) {
      if (const auto job = client_.accounted(known.submission.name)) {
        known.jobs.push_back(*job);
      }
    }
    // squeue lists nothing of it: Slurm has to say so in as many words.
    const Answer known_to_slurm =
        known.jobs.empty() ? Answer::no : client_.knows(known.jobs.front());
    absent.state = known_to_slurm == Answer::no ? State::ended : State::unknown;
  }
  std::fill(known.tasks.begin(), known.tasks.end(), absent);
  for (const SlurmTask& task : listed) {
    if (std::find(known.jobs.begin(), known.jobs.end(), task.job) == known.jobs.end()) {
      known.jobs.push_back(task.job);
    }
    const std::optional<bool> active = is_active_state(task.state);
    const State state = !active                   ? State::unknown
                        : !*active                ? State::ended
                        : task.state == "PENDING" ? State::waiting
                                                  : State::running;
    const bool all = task.index == SlurmTask::kAll;
    const std::size_t first = all ? 0 : static_cast<std::size_t>(task.index);
    const std::size_t end =
        all ? known.tasks.size() : std::min(first + 1, known.tasks.size());
    for (std::size_t i = first; i < end; ++i) {
      // Of two arrays of the same list the one that may still run decides.
      Task& now = known.tasks[i];
      if (now.state == State::ended || state == State::running) {
        now = {state, task.state, task.reason};
      }
    }
  }
}

const SlurmJobs::Task* SlurmJobs::combined(const std::vector<Place>& places) const {
  const Task* out = nullptr;
  for (const Place& place : places) {
    const Task& task = submissions_[place.first].tasks[place.second];
    if (out == nullptr || task.state < out->state) {  // running before unknown, ended
      out = &task;
    }
  }
  return out;
}

std::optional<int> SlurmJobs::waiting(const std::string& realisation_folder) {
  const auto found = realisations_.find(realisation_folder);
  if (found == realisations_.end()) {
    return std::nullopt;
  }
  const Place& last = found->second.back();
  const Known& known = submissions_[last.first];
  if (known.tasks[last.second].state != State::waiting) {
    return std::nullopt;
  }
  const auto& attempts = known.submission.attempts;
  const auto begin = static_cast<std::ptrdiff_t>(last.second) * known.submission.per_task;
  for (std::ptrdiff_t line = begin; line < begin + known.submission.per_task; ++line) {
    const std::string& attempt = attempts[static_cast<std::size_t>(line)];
    if (parent_of(attempt) == realisation_folder) {
      return std::atoi(attempt.substr(attempt.rfind('-') + 1).c_str());
    }
  }
  return std::nullopt;
}

const SlurmJobs::Task* SlurmJobs::task_of(const std::string& attempt_folder) const {
  if (const auto listed = attempts_.find(attempt_folder); listed != attempts_.end()) {
    return combined({listed->second});
  }
  // Else it was begun by a task that Slurm began again.
  const auto found = realisations_.find(parent_of(attempt_folder));
  return found == realisations_.end() ? nullptr : combined(found->second);
}

Presence SlurmJobs::presence(const std::string& attempt_folder) const {
  const Task* task = task_of(attempt_folder);
  if (task == nullptr) {
    return Presence::not_mine;
  }
  if (task->state == State::waiting) {
    return Presence::active;
  }
  look_again(parent_of(attempt_folder));
  if (!std::filesystem::exists(attempt_folder)) {
    return Presence::ended;  // somebody removed it
  }
  look_again(attempt_folder);
  const auto ending = read_if_there(attempt_folder + "/ending.json");
  if (ending && (task->state == State::ended || !was_asked_to_stop(*ending))) {
    return Presence::ended;
  }
  // Slurm may have lost sight of a task that runs (its daemon was killed).
  if (task->state == State::running || FileLock::is_held(attempt_folder + "/lock")) {
    return Presence::active;
  }
  return task->state == State::unknown ? Presence::unknown : Presence::ended;
}

Presence SlurmJobs::conclude(const std::string& attempt_folder) {
  const Presence now = presence(attempt_folder);
  if (now != Presence::ended || !std::filesystem::exists(attempt_folder) ||
      is_file(attempt_folder + "/ending.json")) {
    return now;
  }
  const Task* task = task_of(attempt_folder);
  write_slurm_ending(attempt_folder, task->word, task->reason);
  return Presence::ended;
}

void SlurmJobs::close_ended() {
  bool any = false;
  for (const Known& known : submissions_) {
    const Submission& sent = known.submission;
    const bool gone = std::all_of(known.tasks.begin(), known.tasks.end(),
                                  [](const Task& t) { return t.state == State::ended; });
    const bool have_ended =
        gone && std::all_of(sent.attempts.begin(), sent.attempts.end(),
                            [](const std::string& attempt) {
                              return is_file(attempt + "/ending.json") ||
                                     !std::filesystem::exists(attempt);
                            });
    if (have_ended) {
      journal_.close(sent);
      any = true;
    }
  }
  if (!any) {
    return;
  }
  std::vector<Known> before = std::move(submissions_);
  submissions_.clear();
  attempts_.clear();
  realisations_.clear();
  for (Known& known : before) {
    if (!is_file(known.submission.folder + "/closed")) {
      submissions_.push_back(std::move(known));
      remember(submissions_.size() - 1);
    }
  }
}

SlurmJobs::Counts SlurmJobs::counts() const {
  Counts counts;
  for (const Known& known : submissions_) {
    for (const Task& task : known.tasks) {
      counts.waiting += task.state == State::waiting ? 1 : 0;
      counts.running += task.state == State::running ? 1 : 0;
      counts.unknown += task.state == State::unknown ? 1 : 0;
      if (task.state == State::waiting && !task.reason.empty()) {
        ++counts.reasons[task.reason];
      }
    }
  }
  return counts;
}

void SlurmJobs::cancel(Stop how) const {
  std::vector<std::int64_t> jobs;
  for (const Known& known : submissions_) {
    jobs.insert(jobs.end(), known.jobs.begin(), known.jobs.end());
  }
  if (jobs.empty()) {
    return;
  }
  if (how == Stop::at_once) {
    client_.cancel(jobs, "QUIT");  // what keeps an attempt kills it, and says so
  }
  client_.cancel(jobs, "");
}

}  // namespace colloid
