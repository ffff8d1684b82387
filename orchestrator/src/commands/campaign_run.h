// Runs a campaign's realisations to their end: joins executor, ingester and store.
//
// The database follows what happens by a second at most, because results that are
// ingested together cost half as much (files and pages are still in the processor's
// caches, and one transaction takes all), and because no solver should wait for it.
// Nothing depends on it: what has begun and ended is in the attempts' folders, from which
// catch_up() takes it whenever we are killed.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "base/signals.h"
#include "campaign/run_folder.h"
#include "campaign/solver_program.h"
#include "commands/progress.h"
#include "execute/executor.h"
#include "ingest/ingester.h"
#include "report/target_watch.h"
#include "store/store.h"

namespace colloid {

class CampaignRun {
 public:
  CampaignRun(const Plan& plan, const RunFolder& folder, const SolverProgram& solver,
              Store& store, Executor& executor, const Signals& signals,
              AttemptWatch* watch);

  /// Takes over what is running, starts what is eligible, ingests what ends, until
  /// nothing is left or somebody stops it.  Returns an ExitCode.
  int run();

  /// The same without waiting for anything: for an executor whose jobs outlast us.
  int launch();

  /// Has every realisation that is wanted ended?
  bool has_ended() const { return has_ended_; }
  const TargetWatch& target() const { return target_; }
  /// Why it stopped early; empty if it did not.
  const std::string& why_stopped() const { return why_stopped_; }

 private:
  struct Active {
    AttemptOf attempt;
    std::string folder;
    std::string command;  ///< empty if an earlier process began it
  };

  struct Prepared {
    AttemptOf attempt;
    AttemptRecord record;
    Job job;
  };

  /// The next realisation to start, by index, so that all design points advance together
  /// and what is finished is a prefix of every ensemble.
  bool next(Item& item);
  bool is_to_be_retried(const Item& item) const;
  /// Takes over what an earlier process left behind.
  void begin();
  /// Starts what there is room for.
  void start();
  /// What is to be started next; false if there is nothing.
  bool take(Prepared& prepared);
  /// A realisation's next attempt.
  Prepared prepare(const Item& item);
  /// Prepares the next attempts: many at once, because each alone, between two waits, is
  /// as dear as several.
  void prepare_ahead();
  void adopt(const std::vector<AttemptOf>& running);
  /// Something is about to begin or to end that is not in the database.
  void note_change();
  /// A job has ended; what it left is settled with that of others (record).
  void note_end(std::int64_t id);
  /// Is it time to bring the database up to what has begun and ended?
  bool is_record_due() const;
  void record();
  void settle(const Active& ended);
  void wait_for_event();
  void drain_after_failure();
  /// Is the campaign's target met by what has ended?  If not, more is to be run.
  void look();
  int exit_code();

  const Plan& plan_;
  const RunFolder& folder_;
  const SolverProgram& solver_;
  Store& store_;
  Executor& executor_;
  const Signals& signals_;
  Ingester ingester_;
  TargetWatch target_;
  std::array<long, 5> counts_;
  Progress progress_;
  std::map<std::int64_t, Active> active_;
  std::map<std::int64_t, AttemptRecord>
      begun_;                  ///< of the active ones, not in the database
  std::vector<Active> ended_;  ///< not settled yet
  bool one_failed_ = false;    ///< of the ended ones: without a result
  double first_change_ = 0.0;  ///< of begun_ and ended_ [s]
  std::deque<Item> retries_;   ///< they come first
  std::deque<Prepared> ready_;
  Item cursor_;  ///< after what is ready
  std::int64_t last_id_ = 0;
  int stops_ = 0;        ///< how often somebody asked us to stop
  bool leaves_ = false;  ///< the jobs, which go on
  bool has_ended_ = false;
  std::string why_stopped_;
};

}  // namespace colloid
