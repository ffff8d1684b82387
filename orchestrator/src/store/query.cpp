#include "store/query.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "store/schema.h"

namespace colloid {

namespace {

using nlohmann::json;

json value_of(const Statement& statement, int column) {
  switch (sqlite3_column_type(statement.handle(), column)) {
    case SQLITE_INTEGER:
      return statement.integer(column);
    case SQLITE_FLOAT:
      return statement.real(column);
    case SQLITE_NULL:
      return nullptr;
    default:
      return statement.text(column);
  }
}

/// Refuses what read-only access alone lets pass: other files, and settings.
int authorise(void*, int action, const char*, const char*, const char*, const char*) {
  return action == SQLITE_ATTACH || action == SQLITE_DETACH || action == SQLITE_PRAGMA
             ? SQLITE_DENY
             : SQLITE_OK;
}

}  // namespace

QueryResult ask(const std::string& path, const std::string& sql,
                const std::string& campaign) {
  QueryResult result;
  ask(
      path, sql, campaign, [&](const auto& columns) { result.columns = columns; },
      [&](Row& row) { result.rows.push_back(std::move(row)); });
  return result;
}

void ask(const std::string& path, const std::string& sql, const std::string& campaign,
         const std::function<void(const std::vector<std::string>&)>& take_columns,
         const std::function<void(Row&)>& take_row) {
  const Database database(path, Database::Access::read_only);
  check_schema(database);
  sqlite3_set_authorizer(database.connection(), authorise, nullptr);
  sqlite3_stmt* raw = nullptr;
  const char* rest = nullptr;
  const int code =
      sqlite3_prepare_v2(database.connection(), sql.c_str(), -1, &raw, &rest);
  require(code == SQLITE_OK, "query", sqlite3_errmsg(database.connection()));
  require(raw != nullptr, "query", "is empty, expected a SELECT");
  const bool reads = sqlite3_stmt_readonly(raw) != 0;
  const bool alone = std::string(rest).find_first_not_of(" \t\r\n;") == std::string::npos;
  sqlite3_finalize(raw);
  require(reads, "query", "would change the database, which is only read here");
  require(alone, "query", "has more than one statement");
  Statement statement = database.prepare(sql);
  const int parameter = sqlite3_bind_parameter_index(statement.handle(), ":campaign");
  if (parameter > 0) {
    require(!campaign.empty(), "query", "needs a campaign: poreclog query CAMPAIGN ...");
    statement.bind(parameter, campaign);
  }
  const int columns = sqlite3_column_count(statement.handle());
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(columns));
  for (int i = 0; i < columns; ++i) {
    names.emplace_back(sqlite3_column_name(statement.handle(), i));
  }
  take_columns(names);
  Row row;
  while (statement.step()) {
    row.clear();
    row.reserve(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i) {
      row.push_back(value_of(statement, i));
    }
    take_row(row);
  }
}

const std::vector<CannedQuery>& canned_queries() {
  static const std::vector<CannedQuery> kQueries{
      {"progress", "how many realisations are where, by design point and tier",
       "SELECT point, tier, realisations, ingested, failed, active, eligible, unknown, "
       "clogged, censored FROM v_progress WHERE campaign = :campaign "
       "ORDER BY point, tier"},
      {"points", "the design points and what varies in them",
       "SELECT point, tier, varied FROM v_point WHERE campaign = :campaign "
       "ORDER BY point, tier"},
      {"realisations", "one row per realisation",
       "SELECT point, idx, seed, tier, status, t1_s, tc_s, censored, alpha_deg, "
       "lc_end_m, "
       "permeability_ratio_end, injected, retained, traversed, wall_s, cpu_s, attempts "
       "FROM v_realisation WHERE campaign = :campaign ORDER BY point, tier, idx"},
      {"clogging", "how many clogged; first retention and clogging of those that did",
       "SELECT point, tier, count(*) AS n, sum(censored) AS censored, avg(t1_s) AS "
       "mean_t1_s, avg(tc_s) AS mean_tc_of_clogged_s, min(tc_s) AS min_tc_s, max(tc_s) "
       "AS "
       "max_tc_s FROM v_realisation WHERE campaign = :campaign AND status = 'ingested' "
       "GROUP BY point, tier ORDER BY point, tier"},
      {"curves", "mean critical diameter and permeability against time",
       "SELECT point, tier, time_s, n, critical_diameter_m, critical_diameter_sd_m, "
       "permeability_ratio, permeability_ratio_sd FROM v_curve "
       "WHERE campaign = :campaign ORDER BY point, tier, time_s"},
      {"layers", "where colloids are retained, and by what",
       "SELECT point, tier, layer, mechanism, colloids FROM v_layer "
       "WHERE campaign = :campaign ORDER BY point, tier, layer, mechanism"},
      {"costs", "time and memory",
       "SELECT point, tier, count(*) AS n, avg(wall_s) AS mean_wall_s, max(wall_s) AS "
       "max_wall_s, sum(cpu_s) / 3600.0 AS cpu_hours FROM v_realisation "
       "WHERE campaign = :campaign AND status = 'ingested' GROUP BY point, tier "
       "ORDER BY point, tier"},
      {"failures", "attempts that left no result, and why",
       "SELECT point, idx, tier, attempt, cause, exit_code, signal, node, message "
       "FROM v_attempt WHERE campaign = :campaign AND cause NOT IN ('finished', "
       "'running') "
       "ORDER BY point, tier, idx, attempt"},
      {"incidents", "what went wrong and somebody should know",
       "SELECT point, idx, tier, attempt, kind, text FROM v_incident "
       "WHERE campaign = :campaign ORDER BY point, tier, idx, attempt"},
      {"programs", "which builds on which machines made the results",
       "SELECT version, commit_hash, cpu_model, node, count(*) AS realisations "
       "FROM v_attempt WHERE campaign = :campaign AND cause = 'finished' "
       "GROUP BY version, commit_hash, cpu_model, node ORDER BY realisations DESC"},
  };
  return kQueries;
}

}  // namespace colloid
