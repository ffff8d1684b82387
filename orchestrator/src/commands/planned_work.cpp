#include "commands/planned_work.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/files.h"
#include "store/database.h"
#include "store/schema.h"

namespace colloid {

namespace {

constexpr const char* kNew = "it has not been begun";

/// Why a realisation that the database knows is or is not started; empty: it is not.
std::string reason(const std::string& status, const std::string& last_cause) {
  if (status == "eligible") {
    return last_cause.empty() ? kNew
                              : fmt::format("its last attempt ended: {}", last_cause);
  }
  return "";
}

/// [ensemble][index]: what the database says of each.
std::vector<std::vector<std::string>> reasons(const Plan& plan, const std::string& path) {
  std::vector<std::vector<std::string>> out(
      plan.ensembles.size(),
      std::vector<std::string>(static_cast<std::size_t>(plan.realisations), kNew));
  if (!is_file(path)) {
    return out;
  }
  const Database database(path, Database::Access::read_only);
  check_schema(database);
  for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
    Statement ask = database.prepare(
        "SELECT r.idx, r.status, coalesce((SELECT a.cause FROM attempt a "
        "WHERE a.realisation = r.id ORDER BY a.number DESC LIMIT 1), '') "
        "FROM realisation r JOIN ensemble e ON e.id = r.ensemble "
        "JOIN point p ON p.id = e.point JOIN campaign c ON c.id = p.campaign "
        "WHERE c.name = ? AND p.number = ? AND e.tier = ?");
    ask.bind(1, plan.campaign)
        .bind(2, plan.ensembles[e].point)
        .bind(3, plan.ensembles[e].tier);
    while (ask.step()) {
      const auto index = static_cast<std::size_t>(ask.integer(0));
      if (index < out[e].size()) {
        out[e][index] = reason(ask.text(1), ask.text(2));
      }
    }
  }
  return out;
}

}  // namespace

std::vector<PlannedItem> planned_work(const Plan& plan, const std::string& database) {
  const auto why = reasons(plan, database);
  std::vector<PlannedItem> planned;
  for (int index = 0; index < plan.realisations; ++index) {
    for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
      const std::string& text = why[e][static_cast<std::size_t>(index)];
      if (!text.empty()) {
        planned.push_back({{e, index}, text});
      }
    }
  }
  return planned;
}

nlohmann::ordered_json planned_json(const Plan& plan, const RunFolder& folder,
                                    const std::vector<PlannedItem>& planned) {
  std::map<std::string, long> reasons;
  nlohmann::ordered_json items = nlohmann::ordered_json::array();
  for (const PlannedItem& p : planned) {
    const Ensemble& ensemble = plan.ensembles[p.item.ensemble];
    ++reasons[p.why];
    items.push_back({{"point", ensemble.point},
                     {"tier", ensemble.tier},
                     {"idx", p.item.index},
                     {"why", p.why},
                     {"folder", folder.realisation(plan, p.item)}});
  }
  return {{"schema_version", 1},
          {"campaign", plan.campaign},
          {"executor", plan.executor},
          {"realisations", static_cast<long>(plan.ensembles.size()) * plan.realisations},
          {"to_run", planned.size()},
          {"reasons", reasons},
          {"items", items}};
}

std::string planned_text(const nlohmann::ordered_json& planned) {
  std::string text = fmt::format(
      "{}: {} of {} realisations would run (executor {})\n",
      planned["campaign"].get<std::string>(), planned["to_run"].get<long>(),
      planned["realisations"].get<long>(), planned["executor"].get<std::string>());
  for (const auto& [why, count] : planned["reasons"].items()) {
    text += fmt::format("  {} because {}\n", count.get<long>(), why);
  }
  return text;
}

}  // namespace colloid
