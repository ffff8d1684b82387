#include "commands/open_campaign.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "campaign/changes.h"
#include "campaign/expand.h"
#include "campaign/read_campaign.h"
#include "campaign/run_folder.h"

namespace colloid {

namespace {

bool names_file(const std::string& word) {
  const std::string ending = ".json";
  const bool looks_like_one =
      word.find('/') != std::string::npos ||
      (word.size() > ending.size() &&
       word.compare(word.size() - ending.size(), ending.size(), ending) == 0);
  return looks_like_one || is_file(word);
}

}  // namespace

std::string campaign_name(const std::string& file_or_name) {
  return names_file(file_or_name) ? read_campaign(file_or_name).name : file_or_name;
}

Plan stored_plan(const std::string& name, const CommonOptions& options) {
  const std::vector<std::string> known = campaigns_in(options.runs);
  if (is_campaign_name(name)) {
    if (auto plan = RunFolder(options.runs, name).read_plan()) {
      return std::move(*plan);
    }
  }
  throw InputError(
      "campaign",
      fmt::format("{} has no run folder in {}{}", in_quotes(name), options.runs,
                  known.empty()
                      ? ""
                      : fmt::format("; the nearest is \"{}\"", nearest(name, known))));
}

CLI::Option* add_campaign_option(CLI::App& app, std::string& campaign) {
  return app
      .add_option("campaign", campaign, "A campaign file, or the name of a campaign")
      ->required();
}

OpenedCampaign open_campaign(const std::string& file_or_name,
                             const CommonOptions& options) {
  if (!names_file(file_or_name)) {
    return {stored_plan(file_or_name, options), true};
  }
  const Campaign campaign = read_campaign(file_or_name);
  Plan plan = expand(campaign, SolverProgram::find(options.solver));
  const auto stored = RunFolder(options.runs, campaign.name).read_plan();
  if (!stored) {
    return {std::move(plan), false};
  }
  const std::vector<std::string> changes = forbidden_changes(*stored, plan);
  require(changes.empty(), campaign.path,
          fmt::format("campaign {} has been run with another meaning; give it another "
                      "name, or undo:\n  {}",
                      campaign.name, fmt::join(changes, "\n  ")));
  return {continued(*stored, std::move(plan)), true};
}

}  // namespace colloid
