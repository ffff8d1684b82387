// The rows of one realisation: attempt, outcome, retained colloids, series.
#include <cstring>

#include <fmt/format.h>

#include "base/hash.h"
#include "store/store.h"

namespace colloid {

namespace {

std::string_view bytes_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

// Not ==: NaN is a value here, and -0 is not 0.
bool same_bits(double a, double b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is meant
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

std::optional<std::string_view> if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
}

double last_of(const std::vector<double>& numbers) {
  return numbers.empty() ? kUndefined : numbers.back();
}

}  // namespace

void Store::put_attempt(const Item& item, const AttemptRecord& attempt,
                        const std::optional<std::int64_t>& program) {
  prepared(
      "INSERT OR REPLACE INTO attempt (realisation, number, cause, exit_code, signal, "
      "started, ended, wall_s, cpu_s, memory_kB, node, command, message, provenance) "
      "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)")
      .bind(1, row(item).id)
      .bind(2, attempt.number)
      .bind(3, name_of(attempt.cause))
      .bind(4, attempt.exit_code)
      .bind(5, attempt.signal)
      .bind(6, if_any(attempt.started))
      .bind(7, if_any(attempt.ended))
      .bind(8, attempt.wall_seconds)
      .bind(9, attempt.cpu_seconds)
      .bind(10, attempt.memory_kB)
      .bind(11, if_any(attempt.node))
      .bind(12, attempt.command)
      .bind(13, if_any(attempt.message))
      .bind(14, program)
      .run();
}

void Store::put_incidents(const Item& item, int attempt,
                          const std::vector<Incident>& incidents) {
  for (const Incident& incident : incidents) {
    prepared(
        "INSERT OR REPLACE INTO incident (realisation, attempt, kind, text) "
        "VALUES (?,?,?,?)")
        .bind(1, row(item).id)
        .bind(2, attempt)
        .bind(3, incident.kind)
        .bind(4, incident.text)
        .run();
  }
}

void Store::put_outcome(const Item& item, const AttemptRecord& attempt,
                        const ResultRecord& result) {
  prepared(
      "UPDATE realisation SET status = 'ingested', attempt = ?, tier_run = ?, ending = "
      "?, "
      "duration_s = ?, t1_s = ?, tc_s = ?, alpha_deg = ?, last_traversal_s = ?, "
      "lc_end_m = ?, permeability_ratio_end = ?, injected = ?, retained = ?, "
      "traversed = ?, grid = ?, digest = ? WHERE id = ?")
      .bind(1, attempt.number)
      .bind(2, result.tier)
      .bind(3, result.ending)
      .bind(4, result.duration)
      .bind(5, result.t1)
      .bind(6, result.tc)
      .bind(7, result.alpha_deg)
      .bind(8, result.last_traversal)
      .bind(9, last_of(result.critical_diameter))
      .bind(10, last_of(result.permeability_ratio))
      .bind(11, result.injected)
      .bind(12, result.retained_count)
      .bind(13, result.traversed)
      .bind(14, grid_of(result.times))
      .bind(15, result.digest)
      .bind(16, row(item).id)
      .run();
}

void Store::put_retained(std::int64_t realisation, const ResultRecord& result) {
  Statement& add = prepared(
      "INSERT INTO retained (realisation, retention_order, colloid, time_s, "
      "contact_time_s, x_m, y_m, z_m, injection_x_m, injection_y_m, injection_z_m, "
      "injection_time_s, layer, mechanism, alpha_deg, bond_load_N) "
      "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  for (const RetainedRecord& colloid : result.retained) {
    add.reset()
        .bind(1, realisation)
        .bind(2, colloid.order)
        .bind(3, colloid.colloid)
        .bind(4, colloid.time)
        .bind(5, colloid.contact_time)
        .bind(6, colloid.position[0])
        .bind(7, colloid.position[1])
        .bind(8, colloid.position[2])
        .bind(9, colloid.injection_position[0])
        .bind(10, colloid.injection_position[1])
        .bind(11, colloid.injection_position[2])
        .bind(12, colloid.injection_time)
        .bind(13, if_any(colloid.layer))
        .bind(14, if_any(colloid.mechanism))
        .bind(15, colloid.alpha_deg)
        .bind(16, colloid.bond_load)
        .run();
  }
}

void Store::put_series(std::int64_t realisation, const ResultRecord& result) {
  Statement& add = prepared(
      "INSERT INTO series_change (realisation, step, critical_diameter_m, "
      "permeability_ratio) VALUES (?,?,?,?)");
  for (std::size_t k = 0; k < result.times.size(); ++k) {
    const bool same =
        k > 0 &&
        same_bits(result.critical_diameter[k], result.critical_diameter[k - 1]) &&
        same_bits(result.permeability_ratio[k], result.permeability_ratio[k - 1]);
    if (!same) {
      add.reset()
          .bind(1, realisation)
          .bind(2, static_cast<std::int64_t>(k))
          .bind(3, result.critical_diameter[k])
          .bind(4, result.permeability_ratio[k])
          .run();
    }
  }
}

std::int64_t Store::grid_of(const std::vector<double>& times) {
  if (last_grid_ != 0 && bytes_of(times) == bytes_of(last_times_)) {
    return last_grid_;
  }
  const std::string hash = sha256(bytes_of(times));
  Statement& find = prepared("SELECT id FROM time_grid WHERE hash = ?");
  find.bind(1, hash);
  std::int64_t id = find.step() ? find.integer(0) : 0;
  find.reset();
  if (id == 0) {
    prepared("INSERT INTO time_grid (hash) VALUES (?)").bind(1, hash).run();
    id = database_.last_row();
    Statement& add =
        prepared("INSERT INTO grid_time (grid, step, time_s) VALUES (?,?,?)");
    for (std::size_t k = 0; k < times.size(); ++k) {
      add.reset()
          .bind(1, id)
          .bind(2, static_cast<std::int64_t>(k))
          .bind(3, times[k])
          .run();
    }
  }
  last_times_ = times;
  last_grid_ = id;
  return id;
}

std::int64_t Store::program_of(const ProgramRecord& program) {
  const std::string key = fmt::format(
      "{}\n{}\n{}\n{}\n{}\n{}\n{}", program.version, program.commit, program.compiler,
      program.flags, program.hdf5_version, program.hostname, program.cpu_model);
  const auto known = programs_.find(key);
  if (known != programs_.end()) {
    return known->second;
  }
  const auto bind_all = [&](Statement& statement) -> Statement& {
    return statement.bind(1, program.version)
        .bind(2, program.commit)
        .bind(3, program.compiler)
        .bind(4, program.flags)
        .bind(5, program.hdf5_version)
        .bind(6, program.hostname)
        .bind(7, program.cpu_model);
  };
  bind_all(prepared("INSERT OR IGNORE INTO provenance (version, commit_hash, compiler, "
                    "flags, hdf5_version, hostname, cpu_model) VALUES (?,?,?,?,?,?,?)"))
      .run();
  Statement& find = bind_all(
      prepared("SELECT id FROM provenance WHERE version = ? AND commit_hash = ? AND "
               "compiler = ? AND flags = ? AND hdf5_version = ? AND hostname = ? AND "
               "cpu_model = ?"));
  find.step();
  const std::int64_t id = find.integer(0);
  find.reset();
  programs_[key] = id;
  return id;
}

}  // namespace colloid
