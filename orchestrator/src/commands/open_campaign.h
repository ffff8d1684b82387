// A campaign as named on a command line: the file, or a name that has been run before.
#pragma once

#include <string>

#include "campaign/plan.h"
#include "commands/command.h"

namespace colloid {

/// Declares the positional `campaign` that most commands take; required unless the caller
/// says otherwise.
CLI::Option* add_campaign_option(CLI::App& app, std::string& campaign);

struct OpenedCampaign {
  Plan plan;            ///< what is to be worked on
  bool exists = false;  ///< it has a run folder
};

/// Reads the campaign.  A file is expanded by the solver and compared with the run
/// folder: changes that make finished realisations wrong are refused with their list.
OpenedCampaign open_campaign(const std::string& file_or_name,
                             const CommonOptions& options);

/// The plan in a run folder, by name; refused with the nearest name if there is none.
Plan stored_plan(const std::string& name, const CommonOptions& options);

/// The campaign's name: of the file that is named, or the name itself.
std::string campaign_name(const std::string& file_or_name);

}  // namespace colloid
