#include "report/campaign_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/error.h"
#include "report/paired.h"
#include "report/scene_facts.h"
#include "report/statistics_json.h"
#include "report/target_watch.h"
#include "store/schema.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

/// n x resamples that a summary may cost: some seconds.
constexpr std::size_t kMostDraws = 20'000'000;
constexpr std::size_t kFewestResamples = 400;

const DesignPoint& point_of(const Plan& plan, const Ensemble& ensemble) {
  return *std::find_if(plan.points.begin(), plan.points.end(),
                       [&](const DesignPoint& p) { return p.number == ensemble.point; });
}

EnsembleStatistics summarised(const Plan& plan, std::size_t ensemble,
                              EnsembleSample sample) {
  const SceneFacts facts = scene_facts(plan.ensembles[ensemble].scene);
  std::vector<std::string> warnings;
  statistics::SummaryOptions options;
  options.bootstrap =
      bootstrap_options(plan.statistics.value("confidence", 0.95),
                        plan.statistics.value("bootstrap", std::size_t{2000}),
                        std::strtoull(plan.master_seed.c_str(), nullptr, 10),
                        sample.outcomes.size(), warnings);
  options.duration = facts.duration;
  options.colloid_diameter = facts.colloid_diameter;
  options.inlet = facts.inlet;
  options.inlet_margin = facts.inlet_margin;
  options.hold_last = facts.stops_when_clogged;
  EnsembleStatistics result{ensemble, std::move(sample), {}};
  try {
    result.summary = statistics::summarise(result.sample.outcomes, options);
  } catch (const statistics::InvalidSample& error) {
    throw InputError(
        fmt::format("{}, design point {}", plan.campaign, plan.ensembles[ensemble].point),
        error.what());
  }
  auto& all = result.summary.warnings;
  all.insert(all.end(), warnings.begin(), warnings.end());
  return result;
}

Json json_of(const Plan& plan, const EnsembleStatistics& of) {
  const Ensemble& ensemble = plan.ensembles[of.ensemble];
  Json out{{"point", ensemble.point},
           {"tier", of.sample.tier},
           {"varied", point_of(plan, ensemble).values},
           {"rule", description_of(of.sample.rule)},
           {"interim", of.sample.rule != InterimRule::complete},
           {"n_asked", plan.realisations},
           {"n_running", of.sample.n_running},
           {"n_pending", of.sample.n_pending},
           {"n_beyond_prefix", of.sample.n_beyond_prefix}};
  out.update(to_json(of.summary));
  return out;
}

/// 1.24 (1.10 to 1.37): as many digits as the interval's width calls for.
std::string with_interval(const Json& value, const Json& low, const Json& high,
                          const char* unit) {
  if (value.is_null()) {
    return "not determined";
  }
  const auto number = value.get<double>();
  if (low.is_null() && high.is_null()) {
    return fmt::format("{:.3g}{}", number, unit);
  }
  const double reference = low.is_null() ? number : low.get<double>();
  const double width = high.is_null() ? std::abs(number - reference)
                                      : std::abs(high.get<double>() - reference);
  const int digits =
      width > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(width))), 0, 12)
                  : 3;
  const auto shown = [&](const Json& limit) {
    return limit.is_null() ? std::string("open")
                           : fmt::format("{:.{}f}", limit.get<double>(), digits);
  };
  return fmt::format("{:.{}f}{} ({} to {})", number, digits, unit, shown(low),
                     shown(high));
}

std::string time_line(const char* name, const Json& time) {
  std::string line =
      fmt::format("  {:<26}{}", name,
                  with_interval(time["mean"], time["ci_low"], time["ci_high"], " s"));
  if (time["mean"].is_null() && time.contains("note")) {
    line += ": " + time["note"].get<std::string>();
  }
  return line + "\n";
}

std::string pair_line(const std::string& name, const Json& value, const Json& ci,
                      const char* unit) {
  return fmt::format("  {:<26}{}\n", name,
                     with_interval(value, ci.is_array() ? ci[0] : Json(),
                                   ci.is_array() ? ci[1] : Json(), unit));
}

std::string headlines_of(const Json& point) {
  std::string head;
  if (point.contains("point")) {
    head = fmt::format("design point {}, tier {}", point["point"].get<int>(),
                       point["tier"].get<std::string>());
    if (!point["varied"].empty()) {
      head += ", " + point["varied"].dump();
    }
    head += ": ";
  }
  const long failed = point["n_failed"].get<long>();
  std::string out = fmt::format("{}{} realisations, {} censored{}\n", head,
                                point["n"].get<long>(), point["n_censored"].get<long>(),
                                failed > 0 ? fmt::format(", {} FAILED", failed) : "");
  const Json& clogging = point["clogging"];
  out += time_line("mean t_1", point["t1"]);
  out += time_line("mean t_c", point["tc"]);
  out += time_line("mean t_c - t_1", point["tc_minus_t1"]);
  out += pair_line("median t_c", clogging["median_s"], clogging["median_ci"], " s");
  if (clogging.contains("restricted_mean_tau_s")) {
    const double tau = clogging["restricted_mean_tau_s"].get<double>();
    out += pair_line(fmt::format("mean of min(t_c, {:g} s)", tau),
                     clogging["restricted_mean_s"], clogging["restricted_mean_ci"], " s");
    out += pair_line(fmt::format("P(clogged by {:g} s)", tau),
                     clogging["probability_by_end"], clogging["probability_ci"], "");
  }
  if (point.contains("target") && !point["target"].is_null()) {
    out += "  " + point["target"]["text"].get<std::string>() + "\n";
  }
  for (const Json& warning : point["warnings"]) {
    out += "  note: " + warning.get<std::string>() + "\n";
  }
  return out;
}

}  // namespace

statistics::BootstrapOptions bootstrap_options(double confidence, std::size_t resamples,
                                               std::uint64_t seed, std::size_t n,
                                               std::vector<std::string>& warnings) {
  const std::size_t affordable =
      std::max(kFewestResamples, kMostDraws / std::max<std::size_t>(1, n));
  if (resamples > affordable) {
    warnings.push_back(fmt::format("{} resamples instead of {}: the ensemble is large",
                                   affordable, resamples));
  }
  return {std::min(resamples, affordable), confidence, seed};
}

CampaignStatistics campaign_statistics(const Plan& plan, const RunFolder& folder,
                                       const std::string& path) {
  const Database database(path, Database::Access::read_only);
  check_schema(database);
  const TargetWatch target(plan, database);
  CampaignStatistics result;
  Json points = Json::array();
  for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
    auto sample =
        read_ensemble(database, plan, e, folder,
                      target.state(e).met ? target.wanted(e) : plan.realisations);
    require(sample.has_value(), path,
            fmt::format("does not hold design point {} of campaign {}; `poreclog repair` "
                        "makes the database again",
                        plan.ensembles[e].point, plan.campaign));
    result.ensembles.push_back(summarised(plan, e, std::move(*sample)));
    points.push_back(json_of(plan, result.ensembles.back()));
    points.back()["target"] = target.json(e);
  }
  result.json = {{"schema_version", 1},
                 {"campaign", plan.campaign},
                 {"master_seed", plan.master_seed},
                 {"points", std::move(points)},
                 {"paired_differences", paired_differences(plan, result)}};
  return result;
}

std::string headlines(const Json& statistics) {
  std::string out;
  for (const Json& point : statistics["points"]) {
    out += headlines_of(point);
  }
  if (!statistics["points"].empty()) {
    out += fmt::format("  (in brackets: {:g} % intervals; their methods: --json)\n",
                       100.0 * statistics["points"][0]["confidence"].get<double>());
  }
  return out;
}

}  // namespace colloid
