#include "report/report_content.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/clock.h"
#include "base/error.h"
#include "report/examples.h"
#include "report/statistics_json.h"
#include "store/database.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using statistics::RealisationOutcome;

constexpr std::int64_t kMostRows = 500;    // of the table of realisations
constexpr std::size_t kMostDots = 2000;    // in a scatter plot
constexpr std::size_t kMostSteps = 1000;   // of a survival curve
constexpr std::size_t kMostRegimes = 32;   // the solver takes a moment for each
constexpr std::size_t kMostPictures = 24;  // design points with two realisations shown

Json column_value(const Statement& row, int column) {
  switch (sqlite3_column_type(row.handle(), column)) {
    case SQLITE_INTEGER:
      return row.integer(column);
    case SQLITE_FLOAT:
      return row.real(column);
    case SQLITE_NULL:
      return nullptr;
    default:
      return row.text(column);
  }
}

/// The rows of a bound statement as {"columns": [...], "rows": [[...], ...]}.
Json table_of(Statement& statement) {
  Json columns = Json::array();
  const int count = sqlite3_column_count(statement.handle());
  for (int i = 0; i < count; ++i) {
    columns.push_back(sqlite3_column_name(statement.handle(), i));
  }
  Json rows = Json::array();
  while (statement.step()) {
    Json row = Json::array();
    for (int i = 0; i < count; ++i) {
      row.push_back(column_value(statement, i));
    }
    rows.push_back(std::move(row));
  }
  return {{"columns", std::move(columns)}, {"rows", std::move(rows)}};
}

Json realisations_of(const Database& database, const EnsembleSample& sample) {
  Statement count =
      database.prepare("SELECT count(*) FROM realisation WHERE ensemble = ?");
  const std::int64_t all = count.bind(1, sample.id).step() ? count.integer(0) : 0;
  Statement rows = database.prepare(
      "SELECT r.idx, r.seed, r.status, r.t1_s, r.tc_s, r.alpha_deg, r.lc_end_m, "
      "r.permeability_ratio_end, r.injected, r.retained, r.traversed, a.wall_s, "
      "a.cpu_s, (SELECT count(*) FROM attempt n WHERE n.realisation = r.id) AS attempts "
      "FROM realisation r LEFT JOIN attempt a "
      "ON a.realisation = r.id AND a.number = r.attempt "
      "WHERE r.ensemble = ? AND r.idx % ? = 0 ORDER BY r.idx");
  const std::int64_t stride =
      std::max<std::int64_t>(1, (all + kMostRows - 1) / kMostRows);
  rows.bind(1, sample.id).bind(2, stride);
  Json out = table_of(rows);
  out["all"] = all;
  return out;
}

Json cost_of(const Database& database, std::int64_t ensemble) {
  Statement sum = database.prepare(
      "SELECT count(*) AS attempts, sum(a.wall_s) AS wall_s, sum(a.cpu_s) AS cpu_s, "
      "max(a.memory_kB) AS memory_kB FROM realisation r "
      "JOIN attempt a ON a.realisation = r.id WHERE r.ensemble = ?");
  return table_of(sum.bind(1, ensemble));
}

Json layers_of(const Database& database, std::int64_t ensemble) {
  // Not the table layer_count: that is made anew only when a run ends.
  Statement counts = database.prepare(
      "SELECT d.layer, d.mechanism, count(*) AS colloids FROM realisation r "
      "JOIN retained d ON d.realisation = r.id WHERE r.ensemble = ? "
      "GROUP BY d.layer, d.mechanism ORDER BY colloids DESC");
  return table_of(counts.bind(1, ensemble));
}

/// Every so many, so that no more than `most` are left.
std::vector<const RealisationOutcome*> thinned(const EnsembleSample& sample,
                                               std::size_t most) {
  std::vector<const RealisationOutcome*> finished;
  for (const RealisationOutcome& outcome : sample.outcomes) {
    if (outcome.progress == statistics::Progress::finished) {
      finished.push_back(&outcome);
    }
  }
  const std::size_t stride = (finished.size() + most - 1) / most;
  std::vector<const RealisationOutcome*> kept;
  for (std::size_t i = 0; i < finished.size(); i += std::max<std::size_t>(1, stride)) {
    kept.push_back(finished[i]);
  }
  return kept;
}

Json injection_dots(const EnsembleSample& sample) {
  Json out = Json::array();
  for (const RealisationOutcome* outcome : thinned(sample, kMostDots / 5)) {
    int order = 0;
    for (const auto& place : outcome->injection_positions) {
      out.push_back({place[0], place[1], ++order});
    }
  }
  return out;
}

Json alpha_dots(const statistics::AlphaFit& fit) {
  Json out = Json::array();
  const std::size_t stride = (fit.points.size() + kMostDots - 1) / kMostDots;
  for (std::size_t i = 0; i < fit.points.size(); i += std::max<std::size_t>(1, stride)) {
    const statistics::AlphaPoint& p = fit.points[i];
    out.push_back({{"idx", p.index},
                   {"alpha_deg", p.alpha_deg},
                   {"duration_s", p.duration},
                   {"censored", p.censored},
                   {"lost_m", p.diameter_lost ? Json(*p.diameter_lost) : Json()}});
  }
  return out;
}

Json regime_of(const Plan& plan, const EnsembleStatistics& of,
               const std::optional<SolverProgram>& solver) {
  if (!solver || of.ensemble >= kMostRegimes) {
    return {{"note", solver ? "not asked for: many design points"
                            : "the solver, which computes it, was not found"}};
  }
  try {
    return solver->regime(plan.ensembles[of.ensemble].scene);
  } catch (const InputError& error) {
    return {{"note", error.what()}};  // the report is of results that are there
  }
}

Json point_of(const Database& database, const Plan& plan, const EnsembleStatistics& of,
              Json statistics, const RunFolder& folder,
              const std::optional<SolverProgram>& solver) {
  Json& clogging = statistics["clogging"];
  clogging["kaplan_meier"] = survival_json(of.summary.clogging.kaplan_meier, kMostSteps);
  Json out{{"statistics", std::move(statistics)},
           {"scene", plan.ensembles[of.ensemble].scene},
           {"regime", regime_of(plan, of, solver)},
           {"realisations", realisations_of(database, of.sample)},
           {"layers", layers_of(database, of.sample.id)},
           {"cost", cost_of(database, of.sample.id)},
           {"injection_dots", injection_dots(of.sample)},
           {"alpha_dots", alpha_dots(of.summary.alpha_fit)}};
  out["examples"] =
      of.ensemble < kMostPictures ? examples(database, plan, of, folder) : Json::array();
  return out;
}

}  // namespace

Json report_content(const Plan& plan, const RunFolder& folder, const std::string& path,
                    const CampaignStatistics& statistics,
                    const std::optional<SolverProgram>& solver) {
  const Database database(path, Database::Access::read_only);
  Json points = Json::array();
  for (std::size_t i = 0; i < statistics.ensembles.size(); ++i) {
    points.push_back(point_of(database, plan, statistics.ensembles[i],
                              statistics.json["points"][i], folder, solver));
  }
  const auto of_campaign = [&](const char* sql) {
    Statement rows = database.prepare(sql);
    return table_of(rows.bind(1, plan.campaign));
  };
  return {{"schema_version", 1},
          {"campaign", plan.campaign},
          {"description", plan.description},
          {"master_seed", plan.master_seed},
          {"independent_points", plan.independent_points},
          {"realisations", plan.realisations},
          {"executor", plan.executor},
          {"made", utc_now()},
          {"database", path},
          {"points", std::move(points)},
          {"paired_differences", statistics.json["paired_differences"]},
          {"programs",
           of_campaign("SELECT version, commit_hash, cpu_model, node, count(*) AS "
                       "realisations, min(started) AS first, max(ended) AS last "
                       "FROM v_attempt WHERE campaign = ? AND cause = 'finished' "
                       "GROUP BY version, commit_hash, cpu_model, node")},
          {"failures",
           of_campaign("SELECT point, idx, tier, attempt, cause, message FROM v_attempt "
                       "WHERE campaign = ? AND cause NOT IN ('finished', 'running') "
                       "ORDER BY point, tier, idx, attempt LIMIT 100")},
          {"incidents", of_campaign("SELECT point, idx, tier, attempt, kind, text FROM "
                                    "v_incident WHERE campaign = ? LIMIT 100")}};
}

}  // namespace colloid
