#include "commands/campaign_run.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "commands/command.h"
#include "execute/local_executor.h"

namespace colloid {

namespace {

constexpr std::size_t kTogether = 100;  // results
constexpr double kLongestLag = 1.0;     // [s] of the database
constexpr std::size_t kAhead = 64;      // attempts

long& of(std::array<long, 5>& counts, Status status) {
  return counts.at(static_cast<std::size_t>(status));
}

}  // namespace

CampaignRun::CampaignRun(const Plan& plan, const RunFolder& folder,
                         const SolverProgram& solver, Store& store, Executor& executor,
                         const Signals& signals, AttemptWatch* watch)
    : plan_(plan),
      folder_(folder),
      solver_(solver),
      store_(store),
      executor_(executor),
      signals_(signals),
      ingester_(store, folder, plan, watch),
      target_(plan, store.database()),
      counts_(store.count()),
      progress_(static_cast<long>(plan.ensembles.size()) * plan.realisations,
                of(counts_, Status::ingested)) {}

int CampaignRun::run() {
  try {
    begin();
    start();
    while (!active_.empty() || !ended_.empty()) {
      if (is_record_due()) {
        record();
      } else {
        wait_for_event();
        if (leaves_) {
          break;
        }
        for (const std::int64_t id : executor_.poll()) {
          note_end(id);
        }
      }
      start();
      progress_.show(of(counts_, Status::ingested), of(counts_, Status::failed),
                     static_cast<long>(active_.size()));
    }
    record();
    store_.refresh_curves();
  } catch (const StorageError&) {
    if (!executor_.outlasts_caller()) {
      drain_after_failure();
    }
    throw;
  }
  progress_.show(of(counts_, Status::ingested), of(counts_, Status::failed),
                 static_cast<long>(active_.size()), true);
  return exit_code();
}

int CampaignRun::launch() {
  begin();
  start();
  record();
  if (stops_ == 0) {
    why_stopped_ = executor_.limited_by();
  }
  store_.refresh_curves();
  return exit_code();
}

void CampaignRun::begin() {
  adopt(ingester_.catch_up());
  look();
  counts_ = store_.count();
}

void CampaignRun::adopt(const std::vector<AttemptOf>& running) {
  for (const AttemptOf& attempt : running) {
    const std::string folder =
        attempt_folder(folder_.realisation(plan_, attempt.item), attempt.number);
    const std::int64_t id = ++last_id_;
    active_[id] = {attempt, folder, ""};
    if (!executor_.adopt({id, folder, {}, "", 0.0, 0.0})) {
      note_end(id);  // it has ended since
    }
  }
}

void CampaignRun::start() {
  Prepared next;
  while (stops_ == 0) {
    std::vector<Job> jobs;
    for (std::size_t free = executor_.free_slots(); jobs.size() < free && take(next);) {
      note_change();
      next.job.id = ++last_id_;
      next.record.started = utc_now();
      active_[last_id_] = {next.attempt, next.job.folder, next.record.command};
      begun_[last_id_] = std::move(next.record);
      jobs.push_back(std::move(next.job));
    }
    if (jobs.empty()) {
      return;
    }
    executor_.submit(jobs);
  }
}

void CampaignRun::note_change() {
  if (begun_.empty() && ended_.empty()) {
    first_change_ = monotonic_seconds();
  }
}

void CampaignRun::note_end(std::int64_t id) {
  note_change();
  Active& ended = active_.at(id);
  one_failed_ = one_failed_ || !is_file(ended.folder + "/result.h5");
  ended_.push_back(std::move(ended));
  active_.erase(id);
  begun_.erase(id);
}

bool CampaignRun::is_record_due() const {
  // Failures at once: there may be something to try again, or to stop for.  And what
  // comes from a scheduler: it is asked seldom, and tells of many jobs together.
  return one_failed_ || ended_.size() >= kTogether ||
         (active_.empty() && !ended_.empty()) ||
         ((!begun_.empty() || !ended_.empty()) &&
          (executor_.outlasts_caller() ||
           monotonic_seconds() - first_change_ >= kLongestLag));
}

void CampaignRun::record() {
  Batch batch(store_);
  std::size_t count = 0;
  for (const Active& ended : ended_) {
    settle(ended);
    if (++count % kTogether == 0) {
      batch.commit();  // other campaigns need not wait for thousands
    }
  }
  for (const auto& [id, attempt] : begun_) {
    const Item& item = active_.at(id).attempt.item;
    --of(counts_, store_.status(item));
    store_.begin_attempt(item, attempt);
    ++of(counts_, Status::active);
  }
  batch.commit();
  ended_.clear();
  begun_.clear();
  one_failed_ = false;
  look();
  prepare_ahead();
}

void CampaignRun::look() {
  if (const auto first = target_.look(store_.database())) {
    const int after = ready_.empty() ? cursor_.index : ready_.front().attempt.item.index;
    ready_.clear();
    cursor_ = {0, std::min(after, *first)};
  }
}

bool CampaignRun::take(Prepared& prepared) {
  if (!retries_.empty()) {
    prepared = prepare(retries_.front());
    retries_.pop_front();
    return true;
  }
  if (ready_.empty()) {
    prepare_ahead();
  }
  if (ready_.empty()) {
    return false;
  }
  prepared = std::move(ready_.front());
  ready_.pop_front();
  return true;
}

void CampaignRun::prepare_ahead() {
  for (Item item; ready_.size() < kAhead && next(item);) {
    ready_.push_back(prepare(item));
  }
}

bool CampaignRun::is_to_be_retried(const Item& item) const {
  return std::any_of(retries_.begin(), retries_.end(), [&](const Item& other) {
    return other.ensemble == item.ensemble && other.index == item.index;
  });
}

bool CampaignRun::next(Item& item) {
  while (cursor_.index < plan_.realisations) {
    item = cursor_;
    if (++cursor_.ensemble == plan_.ensembles.size()) {
      cursor_.ensemble = 0;
      ++cursor_.index;
    }
    if (item.index < target_.wanted(item.ensemble) &&
        store_.status(item) == Status::eligible && !is_to_be_retried(item)) {
      return true;
    }
  }
  return false;
}

CampaignRun::Prepared CampaignRun::prepare(const Item& item) {
  const std::string realisation = folder_.realisation(plan_, item);
  const std::vector<int> before = attempts_in(realisation);
  const int number = before.empty() ? 1 : before.back() + 1;
  std::vector<std::string> words = solver_.run_command(
      plan_, item, folder_.scene_file(plan_.ensembles[item.ensemble]), "result.h5");
  words.insert(words.end(),
               {"--checkpoint", realisation + "/checkpoint.h5", "--checkpoint-interval",
                fmt::format("{}", plan_.limits.checkpoint_interval)});
  AttemptRecord record;
  record.number = number;
  record.command = command_line(words);
  record.node = host_name();
  Job job;
  job.folder = attempt_folder(realisation, number);
  job.command = std::move(words);
  job.command_line = record.command;
  job.seconds = plan_.limits.seconds_per_realisation;
  job.seconds_to_stop = plan_.limits.seconds_to_stop;
  return {{item, number}, std::move(record), std::move(job)};
}

void CampaignRun::settle(const Active& ended) {
  const auto [item, number] = ended.attempt;
  --of(counts_, store_.status(item));
  const Settled settled = ingester_.settle(item, number, ended.command);
  ++of(counts_, settled.status);
  if (settled.status == Status::eligible) {
    retries_.push_back(item);
  }
  if (settled.cause == Cause::not_started && stops_ == 0) {
    stops_ = 1;
    why_stopped_ = fmt::format("{} cannot be started", solver_.path());
    executor_.cancel(Stop::politely);
  }
}

void CampaignRun::wait_for_event() {
  double patience = executor_.pace();
  if (!begun_.empty() || !ended_.empty()) {
    patience = std::min(patience, first_change_ + kLongestLag - monotonic_seconds());
  }
  const double end = monotonic_seconds() + patience;
  Signals::Event event = signals_.wait(patience);
  while (event == Signals::Event::child && executor_.outlasts_caller()) {
    // It was the child with which the executor asked its scheduler.
    event = signals_.wait(end - monotonic_seconds());
  }
  if (event != Signals::Event::stop) {
    return;
  }
  ++stops_;
  why_stopped_ = "interrupted";
  if (executor_.outlasts_caller()) {
    leaves_ = true;
    fmt::print(stderr,
               "\nleaving: the jobs go on without this program; `poreclog resume` goes "
               "on, `poreclog cancel` stops them\n");
    return;
  }
  fmt::print(stderr, "\n{}\n",
             stops_ == 1 ? "stopping: the running realisations write checkpoints (once "
                           "more to stop at once)"
                         : "stopping at once");
  executor_.cancel(stops_ == 1 ? Stop::politely : Stop::at_once);
}

void CampaignRun::drain_after_failure() {
  // The database or the disk does not take results any more; those that come in stay in
  // their folders, for `resume`.
  executor_.cancel(Stop::politely);
  const double patience = monotonic_seconds() + plan_.limits.seconds_to_stop + 5.0;
  while (!active_.empty() && monotonic_seconds() < patience) {
    signals_.wait(executor_.pace());
    for (const std::int64_t id : executor_.poll()) {
      active_.erase(id);
    }
  }
}

int CampaignRun::exit_code() {
  counts_ = store_.count();
  has_ended_ = true;
  for (std::size_t e = 0; e < plan_.ensembles.size(); ++e) {
    for (int index = 0; index < target_.wanted(e) && has_ended_; ++index) {
      const Status status = store_.status({e, index});
      has_ended_ = status == Status::ingested || status == Status::failed;
    }
  }
  if (!has_ended_) {
    return why_stopped_ == "interrupted" ? exit_interrupted : exit_stopped;
  }
  if (of(counts_, Status::failed) > 0 || store_.contradictions() > 0) {
    return exit_failures;
  }
  if (target_.is_missed()) {
    why_stopped_ = "the target is not met";
    return exit_stopped;
  }
  return exit_done;
}

}  // namespace colloid
