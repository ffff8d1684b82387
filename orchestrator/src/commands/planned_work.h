// What a run would start now, and why: for --dry-run.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "campaign/run_folder.h"

namespace colloid {

struct PlannedItem {
  Item item;
  std::string why;
};

/// The realisations that a run would start, as far as the database knows, in the order in
/// which they would be.  Nothing is changed: what finished since the last ingestion still
/// counts as to be run, and is ingested first by the run itself.
std::vector<PlannedItem> planned_work(const Plan& plan, const std::string& database);

/// The same for people and programs: how many for which reason, and each of them.
nlohmann::ordered_json planned_json(const Plan& plan, const RunFolder& folder,
                                    const std::vector<PlannedItem>& planned);
std::string planned_text(const nlohmann::ordered_json& planned);

}  // namespace colloid
