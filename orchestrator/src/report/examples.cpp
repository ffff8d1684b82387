#include "report/examples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ingest/hdf5_file.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using statistics::RealisationOutcome;

constexpr std::size_t kMostRows = 400;  // of a series in the report

Json real_or_null(const Statement& row, int column) {
  return row.is_null(column) ? Json() : Json(row.real(column));
}

Json or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json column(hid_t group, const char* name) {
  const auto values = numbers(group, name);
  if (!values) {
    return nullptr;
  }
  Json out = Json::array();
  const std::size_t stride = (values->size() + kMostRows - 1) / kMostRows;
  for (std::size_t i = 0; i < values->size(); ++i) {
    if (i % std::max<std::size_t>(1, stride) == 0 || i + 1 == values->size()) {
      out.push_back(or_null((*values)[i]));
    }
  }
  return out;
}

Json series_of(hid_t file) {
  const auto group = open_group(file, "series");
  if (!group) {
    return nullptr;
  }
  Json out = Json::object();
  for (const char* name :
       {"time_s", "critical_diameter_m", "permeability_ratio", "injected", "retained",
        "first_layer", "multilayer", "traversed"}) {
    out[name] = column(group->get(), name);
  }
  return out["time_s"].is_null() ? Json() : out;
}

/// [[x, y, z, diameter], ...]
Json grains_of(hid_t file) {
  const auto group = open_group(file, "particles/grains");
  const auto centres = group ? numbers(group->get(), "position") : std::nullopt;
  const auto diameters = group ? numbers(group->get(), "diameter") : std::nullopt;
  if (!centres || !diameters || centres->size() != 3 * diameters->size()) {
    return nullptr;
  }
  Json out = Json::array();
  for (std::size_t i = 0; i < diameters->size(); ++i) {
    out.push_back({(*centres)[3 * i], (*centres)[3 * i + 1], (*centres)[3 * i + 2],
                   (*diameters)[i]});
  }
  return out;
}

Json box_of(hid_t file) {
  const auto group = open_group(file, "particles/colloids/box");
  const auto edges = group ? numbers(group->get(), "edges") : std::nullopt;
  return edges && edges->size() == 3 ? Json(*edges) : Json();
}

Json retained_of(const Database& database, std::int64_t realisation) {
  Statement rows = database.prepare(
      "SELECT time_s, x_m, y_m, z_m, layer, mechanism FROM retained "
      "WHERE realisation = ? ORDER BY retention_order");
  rows.bind(1, realisation);
  Json out = Json::array();
  while (rows.step()) {
    out.push_back({{"time_s", real_or_null(rows, 0)},
                   {"x_m", real_or_null(rows, 1)},
                   {"y_m", real_or_null(rows, 2)},
                   {"z_m", real_or_null(rows, 3)},
                   {"layer", rows.text(4)},
                   {"mechanism", rows.text(5)}});
  }
  return out;
}

Json example(const Database& database, const Plan& plan, const EnsembleStatistics& of,
             const RunFolder& folder, const RealisationOutcome& outcome,
             const char* title) {
  Statement find = database.prepare(
      "SELECT id, seed, attempt FROM realisation WHERE ensemble = ? AND idx = ?");
  find.bind(1, of.sample.id).bind(2, static_cast<std::int64_t>(outcome.index));
  find.step();
  Json out{{"title", title},
           {"idx", outcome.index},
           {"seed", find.text(1)},
           {"t1_s", outcome.t1 ? Json(*outcome.t1) : Json()},
           {"tc_s", outcome.tc ? Json(*outcome.tc) : Json()},
           {"end_s", outcome.end},
           {"retained", retained_of(database, find.integer(0))},
           {"series", nullptr},
           {"grains", nullptr},
           {"box_m", nullptr}};
  const Item item{of.ensemble, static_cast<int>(outcome.index)};
  const std::string attempt =
      attempt_folder(folder.realisation(plan, item), static_cast<int>(find.integer(2)));
  if (const auto file = open_hdf5(attempt + "/result.h5")) {
    out["series"] = series_of(file->get());
    out["grains"] = grains_of(file->get());
    out["box_m"] = box_of(file->get());
  }
  return out;
}

}  // namespace

Json examples(const Database& database, const Plan& plan, const EnsembleStatistics& of,
              const RunFolder& folder) {
  std::vector<const RealisationOutcome*> finished;
  for (const RealisationOutcome& outcome : of.sample.outcomes) {
    if (outcome.progress == statistics::Progress::finished) {
      finished.push_back(&outcome);
    }
  }
  const auto time = [](const RealisationOutcome* o) {
    return o->tc.value_or(std::numeric_limits<double>::infinity());
  };
  std::stable_sort(finished.begin(), finished.end(),
                   [&](const auto* a, const auto* b) { return time(a) < time(b); });
  Json out = Json::array();
  if (finished.empty()) {
    return out;
  }
  const auto show = [&](const RealisationOutcome* outcome, const char* title) {
    out.push_back(example(database, plan, of, folder, *outcome, title));
  };
  const bool any_clogged = finished.front()->tc.has_value();
  show(finished.front(), any_clogged ? "The first to clog" : "One that did not clog");
  if (finished.size() > 1) {
    const RealisationOutcome* last = finished.back();
    show(last, last->tc ? "The last to clog" : "One that did not clog");
  }
  return out;
}

}  // namespace colloid
