// Leaves statistics.json and report.html of a campaign in a folder.
#pragma once

#include <string>

#include "campaign/plan.h"
#include "commands/command.h"

namespace colloid {

struct WrittenReport {
  std::string folder;
  std::string page;       ///< report.html
  std::string headlines;  ///< lines for a terminal
};

/// `output`: the folder; results/reports/<campaign> if empty.
WrittenReport write_report(const Plan& plan, const CommonOptions& options,
                           const std::string& output);

}  // namespace colloid
