// The writer's side of the results database: one campaign's rows.
//
// One process writes (it holds the campaign's lock); each realisation is in one
// transaction, alone or with others that ended at the same time (Batch), idempotent on
// (campaign, hash of the design point, tier, index).  The journal is a write-ahead log:
// readers never wait for the writer nor the writer for readers.  It is not synchronised
// at every commit: after a power cut the last commits may be missing, and are made again
// from the run folders, which are.  So is a batch that a kill cut off.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "campaign/plan.h"
#include "store/database.h"
#include "store/records.h"

namespace colloid {

enum class Status { ingested, failed, active, eligible, unknown };

const char* name_of(Status status);

/// Something that went wrong and somebody should know.
struct Incident {
  std::string kind;
  std::string text;
};

class Store {
 public:
  /// Opens the database, makes or migrates its tables, and adds the plan's rows that are
  /// not there yet.  `folder`: the campaign's run folder; a database that holds the
  /// campaign of another one is refused.
  Store(const std::string& path, const Plan& plan, const std::string& folder);

  Status status(const Item& item) const { return row(item).status; }
  /// Realisations by status, in the order of the enumeration.
  std::array<long, 5> count() const;
  /// Incidents of that kind in the campaign.
  long contradictions();
  std::vector<AttemptRecord> attempts(const Item& item);
  /// Attempts up to this number do not count as failures any more.
  int forgiven(const Item& item);
  /// Realisations with an attempt that is said to be running.
  std::vector<Item> with_running_attempts();

  /// An attempt is about to start: the realisation is active.
  void begin_attempt(const Item& item, const AttemptRecord& attempt);
  /// An attempt has ended, and where that leaves the realisation.
  void end_attempt(const Item& item, const AttemptRecord& attempt, Status status,
                   const std::vector<Incident>& incidents);
  /// The same with the result it left, which is ingested.
  void ingest(const Item& item, const AttemptRecord& attempt, const ResultRecord& result);
  /// The same with another result of a realisation that is ingested already: compares
  /// them, and notes a duplicate or a contradiction.
  void compare(const Item& item, const AttemptRecord& attempt,
               const ResultRecord& result);
  void set_status(const Item& item, Status status);
  void forgive(const Item& item, int attempts);

  /// Makes the ensembles' mean curves anew where realisations were added.
  void refresh_curves();

  Database& database() { return database_; }

 private:
  friend class Batch;

  struct Row {
    std::int64_t id = 0;
    Status status = Status::eligible;
  };

  /// Does `write` within the open batch, or in a transaction of its own.
  template <class Write>
  void change(Write write);
  void commit();
  /// StorageError if the file has been deleted or replaced: rows would go nowhere.
  void require_still_there() const;

  void put_campaign(const Plan& plan, const std::string& folder);
  void refuse_other_folder(const std::string& campaign, const std::string& folder);
  std::int64_t put_point(std::int64_t campaign, const DesignPoint& point);
  std::int64_t put_ensemble(std::int64_t point, const Ensemble& ensemble);
  void put_realisations(const Plan& plan, std::size_t ensemble);
  void put_attempt(const Item& item, const AttemptRecord& attempt,
                   const std::optional<std::int64_t>& program);
  void put_incidents(const Item& item, int attempt,
                     const std::vector<Incident>& incidents);
  void put_outcome(const Item& item, const AttemptRecord& attempt,
                   const ResultRecord& result);
  void put_retained(std::int64_t realisation, const ResultRecord& result);
  void put_series(std::int64_t realisation, const ResultRecord& result);
  std::int64_t grid_of(const std::vector<double>& times);
  std::int64_t program_of(const ProgramRecord& program);
  void write_status(const Item& item, Status status);
  Row& row(const Item& item) {
    return rows_[item.ensemble][static_cast<std::size_t>(item.index)];
  }
  const Row& row(const Item& item) const {
    return rows_[item.ensemble][static_cast<std::size_t>(item.index)];
  }

  Database database_;
  std::vector<std::int64_t> ensembles_;  ///< ids
  std::vector<bool> curve_is_old_;       ///< by ensemble
  std::vector<std::vector<Row>> rows_;   ///< [ensemble][index]
  std::vector<double> last_times_;
  std::int64_t last_grid_ = 0;
  std::unordered_map<std::string, std::int64_t> programs_;
  std::unordered_map<const char*, Statement> statements_;  ///< by their texts' places
  std::uint64_t inode_ = 0;
  bool in_batch_ = false;
  std::optional<Transaction> transaction_;

  /// The statement, prepared once; `sql` is a literal.
  Statement& prepared(const char* sql);
};

/// The changes between construction and commit() in one transaction, which costs hardly
/// more than that of one change; without commit() none of them.  After an exception the
/// store is of no use any more: what it remembers is not what is in the file.
///
/// To be committed before waiting for anything: other campaigns write to the same file.
class Batch {
 public:
  explicit Batch(Store& store) : store_(store) { store_.in_batch_ = true; }
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  ~Batch() {
    store_.transaction_.reset();
    store_.in_batch_ = false;
  }
  void commit() { store_.commit(); }

 private:
  Store& store_;
};

}  // namespace colloid
