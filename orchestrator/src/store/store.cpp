#include "store/store.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include "base/error.h"
#include "base/hash.h"
#include "store/curves.h"
#include "store/schema.h"

namespace colloid {

namespace {

constexpr std::array<const char*, 5> kStatusNames{"ingested", "failed", "active",
                                                  "eligible", "unknown"};

Status status_named(const std::string& name) {
  const auto* const found = std::find(kStatusNames.begin(), kStatusNames.end(), name);
  return static_cast<Status>(found - kStatusNames.begin());
}

std::uint64_t inode_of(const std::string& path) {
  struct stat state {};
  return ::stat(path.c_str(), &state) == 0 ? state.st_ino : 0;
}

/// SQLite's locks and shared memory do not work on file systems of clusters: campaigns of
/// other programs were lost that way.
void refuse_network_file_system(const std::string& path) {
  struct statfs state {};
  if (::statfs(path.c_str(), &state) != 0) {
    return;
  }
  const std::array<std::pair<std::uint32_t, const char*>, 6> networks{{
      {0x6969, "NFS"},
      {0x0BD00BD0, "Lustre"},
      {0x47504653, "GPFS"},
      {0xFF534D42, "CIFS"},
      {0xFE534D42, "SMB"},
      {0x19830326, "BeeGFS"},
  }};
  for (const auto& [magic, name] : networks) {
    require(static_cast<std::uint32_t>(state.f_type) != magic, path,
            fmt::format("is on {}, on which SQLite loses data; name a file on a local "
                        "disk with --database (the runs may stay where they are)",
                        name));
  }
}

}  // namespace

const char* name_of(Status status) {
  return kStatusNames.at(static_cast<std::size_t>(status));
}

Store::Store(const std::string& path, const Plan& plan, const std::string& folder)
    : database_(path, Database::Access::read_write) {
  refuse_network_file_system(path);
  database_.execute(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; "
      "PRAGMA foreign_keys = ON; PRAGMA wal_autocheckpoint = 4000");
  prepare_schema(database_);
  Transaction transaction(database_);
  put_campaign(plan, folder);
  transaction.commit();
  inode_ = inode_of(path);
}

Statement& Store::prepared(const char* sql) {
  const auto found = statements_.find(sql);
  if (found != statements_.end()) {
    return found->second.reset();
  }
  return statements_.emplace(sql, database_.prepare(sql)).first->second;
}

void Store::put_campaign(const Plan& plan, const std::string& folder) {
  refuse_other_folder(plan.campaign, folder);
  prepared(
      "INSERT INTO campaign (name, description, master_seed, independent_points, "
      "realisations, statistics, folder) VALUES (?,?,?,?,?,?,?) "
      "ON CONFLICT (name) DO UPDATE SET description = excluded.description, "
      "realisations = excluded.realisations, statistics = excluded.statistics, "
      "folder = excluded.folder")
      .bind(1, plan.campaign)
      .bind(2, plan.description)
      .bind(3, plan.master_seed)
      .bind(4, plan.independent_points ? 1 : 0)
      .bind(5, plan.realisations)
      .bind(6, plan.statistics.dump())
      .bind(7, folder)
      .run();
  Statement& find = prepared("SELECT id FROM campaign WHERE name = ?");
  find.bind(1, plan.campaign).step();
  const std::int64_t campaign = find.integer(0);
  find.reset();
  for (std::size_t i = 0; i < plan.ensembles.size(); ++i) {
    const Ensemble& ensemble = plan.ensembles[i];
    const auto point =
        std::find_if(plan.points.begin(), plan.points.end(),
                     [&](const auto& p) { return p.number == ensemble.point; });
    ensembles_.push_back(put_ensemble(put_point(campaign, *point), ensemble));
    curve_is_old_.push_back(false);
    rows_.emplace_back(static_cast<std::size_t>(plan.realisations));
    put_realisations(plan, i);
  }
}

void Store::refuse_other_folder(const std::string& campaign, const std::string& folder) {
  Statement& find = prepared("SELECT folder FROM campaign WHERE name = ?");
  const std::string other = find.bind(1, campaign).step() ? find.text(0) : folder;
  find.reset();
  std::error_code ignored;
  require(other == folder || !std::filesystem::exists(other + "/campaign.json", ignored),
          database_.path(),
          fmt::format("holds campaign {} of the run folder {}, not of {}: give that "
                      "--runs, another --database, or the campaign another name",
                      campaign, other, folder));
}

std::int64_t Store::put_point(std::int64_t campaign, const DesignPoint& point) {
  prepared(
      "INSERT INTO point (campaign, number, hash, varied) VALUES (?,?,?,?) "
      "ON CONFLICT (campaign, hash) DO NOTHING")
      .bind(1, campaign)
      .bind(2, point.number)
      .bind(3, point.hash)
      .bind(4, point.values.dump())
      .run();
  Statement& find = prepared("SELECT id FROM point WHERE campaign = ? AND hash = ?");
  find.bind(1, campaign).bind(2, point.hash).step();
  const std::int64_t id = find.integer(0);
  find.reset();
  return id;
}

std::int64_t Store::put_ensemble(std::int64_t point, const Ensemble& ensemble) {
  prepared("INSERT OR IGNORE INTO scene (hash, text) VALUES (?,?)")
      .bind(1, ensemble.scene_hash)
      .bind(2, ensemble.scene.dump())
      .run();
  prepared("INSERT OR IGNORE INTO ensemble (point, tier, scene) VALUES (?,?,?)")
      .bind(1, point)
      .bind(2, ensemble.tier)
      .bind(3, ensemble.scene_hash)
      .run();
  Statement& find =
      prepared("SELECT id, scene FROM ensemble WHERE point = ? AND tier = ?");
  find.bind(1, point).bind(2, ensemble.tier).step();
  const std::int64_t id = find.integer(0);
  const std::string scene = find.text(1);
  find.reset();
  require(scene == ensemble.scene_hash, database_.path(),
          fmt::format("has another scene for tier {} of this campaign than its run "
                      "folder: use another --database, or `poreclog repair`",
                      ensemble.tier));
  return id;
}

void Store::put_realisations(const Plan& plan, std::size_t ensemble) {
  std::vector<Row>& rows = rows_[ensemble];
  Statement& find =
      prepared("SELECT idx, id, status FROM realisation WHERE ensemble = ?");
  find.bind(1, ensembles_[ensemble]);
  while (find.step()) {
    const auto index = static_cast<std::size_t>(find.integer(0));
    if (index < rows.size()) {
      rows[index] = {find.integer(1), status_named(find.text(2))};
    }
  }
  Statement& add = prepared(
      "INSERT INTO realisation (ensemble, idx, seed, status) VALUES (?,?,?,'eligible')");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].id == 0) {
      const int index = static_cast<int>(i);
      add.reset()
          .bind(1, ensembles_[ensemble])
          .bind(2, index)
          .bind(3, std::to_string(seed_of(plan, {ensemble, index})))
          .run();
      rows[i].id = database_.last_row();
    }
  }
}

std::vector<AttemptRecord> Store::attempts(const Item& item) {
  Statement& find = prepared(
      "SELECT number, cause, command FROM attempt WHERE realisation = ? ORDER BY number");
  find.bind(1, row(item).id);
  std::vector<AttemptRecord> out;
  while (find.step()) {
    AttemptRecord attempt;
    attempt.number = static_cast<int>(find.integer(0));
    attempt.cause = cause_named(find.text(1));
    attempt.command = find.text(2);
    out.push_back(std::move(attempt));
  }
  return out;
}

int Store::forgiven(const Item& item) {
  Statement& find = prepared("SELECT forgiven FROM realisation WHERE id = ?");
  find.bind(1, row(item).id).step();
  const int count = static_cast<int>(find.integer(0));
  find.reset();
  return count;
}

std::vector<Item> Store::with_running_attempts() {
  std::vector<Item> out;
  for (std::size_t e = 0; e < ensembles_.size(); ++e) {
    Statement& find = prepared(
        "SELECT DISTINCT r.idx FROM attempt a JOIN realisation r ON r.id = a.realisation "
        "WHERE r.ensemble = ? AND a.cause = 'running' ORDER BY r.idx");
    find.bind(1, ensembles_[e]);
    while (find.step()) {
      out.push_back({e, static_cast<int>(find.integer(0))});
    }
  }
  return out;
}

template <class Write>
void Store::change(Write write) {
  if (!transaction_) {
    require_still_there();
    transaction_.emplace(database_);
  }
  try {
    write();
  } catch (...) {
    transaction_.reset();
    throw;
  }
  if (!in_batch_) {
    commit();
  }
}

void Store::commit() {
  if (transaction_) {
    transaction_->commit();
    transaction_.reset();
  }
}

void Store::begin_attempt(const Item& item, const AttemptRecord& attempt) {
  change([&] {
    put_attempt(item, attempt, std::nullopt);
    write_status(item, Status::active);
  });
}

void Store::end_attempt(const Item& item, const AttemptRecord& attempt, Status status,
                        const std::vector<Incident>& incidents) {
  change([&] {
    put_attempt(item, attempt, std::nullopt);
    put_incidents(item, attempt.number, incidents);
    write_status(item, status);
  });
}

void Store::ingest(const Item& item, const AttemptRecord& attempt,
                   const ResultRecord& result) {
  change([&] {
    put_attempt(item, attempt, program_of(result.program));
    put_outcome(item, attempt, result);
    put_retained(row(item).id, result);
    put_series(row(item).id, result);
  });
  row(item).status = Status::ingested;
  curve_is_old_[item.ensemble] = true;
}

void Store::compare(const Item& item, const AttemptRecord& attempt,
                    const ResultRecord& result) {
  change([&] {
    Statement& find = prepared("SELECT digest, attempt FROM realisation WHERE id = ?");
    find.bind(1, row(item).id).step();
    const bool same = find.text(0) == result.digest;
    const std::int64_t first = find.integer(1);
    find.reset();
    put_attempt(item, attempt, program_of(result.program));
    put_incidents(
        item, attempt.number,
        {same ? Incident{"duplicate", fmt::format("the same as attempt {}", first)}
              : Incident{"contradiction",
                         fmt::format("differs from attempt {}, which was ingested: the "
                                     "solver did not repeat itself",
                                     first)}});
  });
}

std::array<long, 5> Store::count() const {
  std::array<long, 5> counts{};
  for (const std::vector<Row>& rows : rows_) {
    for (const Row& r : rows) {
      ++counts.at(static_cast<std::size_t>(r.status));
    }
  }
  return counts;
}

long Store::contradictions() {
  Statement& count = prepared(
      "SELECT count(*) FROM incident i JOIN realisation r ON r.id = i.realisation "
      "JOIN ensemble e ON e.id = r.ensemble JOIN point p ON p.id = e.point "
      "WHERE i.kind = 'contradiction' AND p.campaign = "
      "(SELECT p2.campaign FROM point p2 JOIN ensemble e2 ON e2.point = p2.id "
      "WHERE e2.id = ?)");
  count.bind(1, ensembles_.front()).step();
  const long number = count.integer(0);
  count.reset();
  return number;
}

void Store::set_status(const Item& item, Status status) {
  change([&] { write_status(item, status); });
}

void Store::forgive(const Item& item, int attempts) {
  change([&] {
    prepared("UPDATE realisation SET forgiven = ? WHERE id = ?")
        .bind(1, attempts)
        .bind(2, row(item).id)
        .run();
    write_status(item, Status::eligible);
  });
}

void Store::refresh_curves() {
  for (std::size_t e = 0; e < ensembles_.size(); ++e) {
    if (curve_is_old_[e]) {
      change([&] {
        write_curve(database_, ensembles_[e]);
        write_layer_counts(database_, ensembles_[e]);
      });
      curve_is_old_[e] = false;
    }
  }
}

void Store::require_still_there() const {
  if (inode_of(database_.path()) != inode_) {
    throw StorageError(fmt::format(
        "{}: the database was deleted or replaced while it was in use; nothing is lost: "
        "`poreclog resume` makes it again from the run folders",
        database_.path()));
  }
}

void Store::write_status(const Item& item, Status status) {
  prepared("UPDATE realisation SET status = ? WHERE id = ?")
      .bind(1, name_of(status))
      .bind(2, row(item).id)
      .run();
  row(item).status = status;
}

}  // namespace colloid
