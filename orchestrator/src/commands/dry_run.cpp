#include "commands/dry_run.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "base/file_lock.h"
#include "base/files.h"
#include "campaign/target.h"
#include "commands/slurm_campaign.h"
#include "commands/slurm_plan.h"
#include "ingest/prospect.h"
#include "report/target_watch.h"
#include "store/database.h"
#include "store/schema.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRanges = 8;  // in a line for people

Json class_json(const Prospect& prospect) {
  Json ranges = Json::array();
  for (const auto& [first, last] : prospect.indices) {
    ranges.push_back({first, last});
  }
  return {{"action", prospect.action},
          {"reason", prospect.reason},
          {"text", prospect.text},
          {"count", prospect.count},
          {"indices", ranges}};
}

/// Which realisations the campaign's target wants for now; all of them without one.
std::vector<Wanted> wanted_of(const Plan& plan, const std::string& path) {
  const auto target = target_of(plan.statistics, plan.realisations);
  std::vector<Wanted> out(plan.ensembles.size(),
                          {target ? target->pilot : plan.realisations, false});
  if (target && is_file(path)) {
    const Database database(path, Database::Access::read_only);
    check_schema(database);
    const TargetWatch watch(plan, database);
    for (std::size_t e = 0; e < out.size(); ++e) {
      out[e] = {watch.wanted(e), watch.state(e).met};
    }
  }
  return out;
}

std::string ranges_text(const Json& ranges) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ranges.size(), kMostRanges); ++i) {
    const int first = ranges[i][0].get<int>();
    const int last = ranges[i][1].get<int>();
    text += i == 0 ? "" : ", ";
    text += first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
  }
  return text + (ranges.size() > kMostRanges ? ", ..." : "");
}

}  // namespace

Json dry_run(const Plan& plan, const CommonOptions& options) {
  const RunFolder folder(options.runs, plan.campaign);
  const auto slurm = plan.executor == "slurm"
                         ? std::make_unique<SlurmCampaign>(
                               plan, folder, SlurmCampaign::Access::read_only)
                         : nullptr;
  const std::vector<Wanted> wanted = wanted_of(plan, absolute(options.database));
  Json ensembles = Json::array();
  long to_run = 0;
  for (std::size_t e = 0; e < plan.ensembles.size(); ++e) {
    const Ensemble& ensemble = plan.ensembles[e];
    Json classes = Json::array();
    for (const Prospect& prospect :
         prospects(plan, e, folder, absolute(options.database),
                   slurm ? &slurm->jobs() : nullptr, wanted[e])) {
      to_run += prospect.action == "run" ? prospect.count : 0;
      classes.push_back(class_json(prospect));
    }
    const auto point =
        std::find_if(plan.points.begin(), plan.points.end(),
                     [&](const DesignPoint& p) { return p.number == ensemble.point; });
    ensembles.push_back({{"point", ensemble.point},
                         {"tier", ensemble.tier},
                         {"varied", point->values},
                         {"classes", classes}});
  }
  Json answer{
      {"schema_version", 1},
      {"campaign", plan.campaign},
      {"dry_run", true},
      {"executor", plan.executor},
      {"running", FileLock::is_held(folder.lock_file())},
      {"realisations", static_cast<long>(plan.ensembles.size()) * plan.realisations},
      {"to_run", to_run},
      {"ensembles", ensembles}};
  if (slurm) {
    answer["slurm"] = slurm_plan(plan, folder, slurm->client(), to_run);
  }
  return answer;
}

std::string dry_run_text(const Json& answer) {
  std::string text = fmt::format(
      "{}: {} of {} realisations would be run{}\n", answer["campaign"].get<std::string>(),
      answer["to_run"].get<long>(), answer["realisations"].get<long>(),
      answer["running"].get<bool>() ? ", but another poreclog is at work on this campaign"
                                    : "");
  for (const Json& ensemble : answer["ensembles"]) {
    text += fmt::format("point {}  tier {}  {}\n", ensemble["point"].get<int>(),
                        ensemble["tier"].get<std::string>(), ensemble["varied"].dump());
    for (const Json& one : ensemble["classes"]) {
      text += fmt::format("  {:<9} {:>8}  {}  [{}]\n", one["action"].get<std::string>(),
                          one["count"].get<long>(), one["text"].get<std::string>(),
                          ranges_text(one["indices"]));
    }
  }
  if (answer.contains("slurm")) {
    text += slurm_plan_text(answer["slurm"]);
  }
  return text;
}

}  // namespace colloid
