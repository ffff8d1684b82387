#include "report/paired.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "campaign/plan.h"
#include "report/campaign_statistics.h"
#include "report/scene_facts.h"
#include "report/statistics_json.h"
#include "statistics/mean_interval.h"
#include "statistics/prefix.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using statistics::RealisationOutcome;
using Quantity = std::function<std::optional<double>(const RealisationOutcome&)>;

/// Mean difference over the seeds of which both have the quantity.
Json difference(const EnsembleStatistics& of, const EnsembleStatistics& from,
                const Quantity& quantity, double level) {
  const auto ours = statistics::complete_prefix(of.sample.outcomes).finished;
  const auto theirs = statistics::complete_prefix(from.sample.outcomes).finished;
  std::vector<double> sample;
  std::vector<double> here_all;
  std::vector<double> there_all;
  std::size_t without = 0;
  auto other = theirs.begin();
  for (const RealisationOutcome* outcome : ours) {
    other = std::find_if(other, theirs.end(), [&](const RealisationOutcome* o) {
      return o->index >= outcome->index;
    });
    if (other == theirs.end()) {
      break;
    }
    if ((*other)->index != outcome->index) {
      continue;
    }
    const auto here = quantity(*outcome);
    const auto there = quantity(**other);
    if (here && there) {
      sample.push_back(*here - *there);
      here_all.push_back(*here);
      there_all.push_back(*there);
    } else {
      ++without;
    }
  }
  // A difference of the others would be biased: those without an event are the late ones.
  const auto mean =
      statistics::mean_interval(without == 0 ? sample : std::vector<double>{}, level);
  Json out{{"n", sample.size()}, {"n_without", without}};
  out["mean"] = mean.mean ? Json(*mean.mean) : Json();
  out["sd"] = mean.sd ? Json(*mean.sd) : Json();
  const auto ours_alone = statistics::mean_interval(here_all, level);
  const auto theirs_alone = statistics::mean_interval(there_all, level);
  out["sd_if_independent"] = ours_alone.sd && theirs_alone.sd
                                 ? Json(std::hypot(*ours_alone.sd, *theirs_alone.sd))
                                 : Json();
  out["ci_low"] = mean.interval ? Json(mean.interval->low) : Json();
  out["ci_high"] = mean.interval ? Json(mean.interval->high) : Json();
  out["method"] = "paired by seed; " + mean.method;
  return out;
}

Json compare(const Plan& plan, const EnsembleStatistics& of,
             const EnsembleStatistics& from) {
  const Ensemble& ours = plan.ensembles[of.ensemble];
  const Ensemble& theirs = plan.ensembles[from.ensemble];
  Json out{{"point", ours.point}, {"from_point", theirs.point}, {"tier", of.sample.tier}};
  const double level = of.summary.level;
  out["t1"] = difference(
      of, from, [](const RealisationOutcome& o) { return o.t1; }, level);
  const auto tau = scene_facts(ours.scene).duration;
  const auto other_tau = scene_facts(theirs.scene).duration;
  if (tau && other_tau) {
    const double until = std::min(*tau, *other_tau);
    out["restricted_tc"] = difference(
        of, from,
        [until](const RealisationOutcome& o) -> std::optional<double> {
          const double reached = o.tc.value_or(o.end);
          return o.tc || o.end >= until * (1.0 - 1e-9)
                     ? std::optional(std::min(reached, until))
                     : std::nullopt;
        },
        level);
    out["restricted_tc"]["tau_s"] = until;
  }
  return out;
}

}  // namespace

Json paired_differences(const Plan& plan, const CampaignStatistics& statistics) {
  Json out = Json::array();
  if (plan.independent_points) {
    return out;
  }
  for (const EnsembleStatistics& of : statistics.ensembles) {
    const auto first = std::find_if(
        statistics.ensembles.begin(), statistics.ensembles.end(),
        [&](const EnsembleStatistics& other) {
          return plan.ensembles[other.ensemble].tier == plan.ensembles[of.ensemble].tier;
        });
    if (first->ensemble != of.ensemble) {
      out.push_back(compare(plan, of, *first));
    }
  }
  return out;
}

}  // namespace colloid
