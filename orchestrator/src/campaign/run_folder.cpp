#include "campaign/run_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <dirent.h>
#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "campaign/read_campaign.h"

namespace colloid {

namespace {

/// Names in a folder; none if there is no folder.
std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  DIR* stream = ::opendir(folder.c_str());
  if (stream == nullptr) {
    return names;
  }
  while (const dirent* entry = ::readdir(stream)) {
    names.emplace_back(entry->d_name);
  }
  ::closedir(stream);
  return names;
}

/// Numbers of the names that are `prefix` and digits, ascending.
std::vector<int> numbered(const std::string& folder, const std::string& prefix) {
  std::vector<int> numbers;
  for (const std::string& name : names_in(folder)) {
    const bool fits =
        name.compare(0, prefix.size(), prefix) == 0 && name.size() > prefix.size() &&
        name.size() < prefix.size() + 10 &&
        name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
    if (fits) {
      numbers.push_back(std::atoi(name.c_str() + prefix.size()));
    }
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

RunFolder::RunFolder(const std::string& runs, const std::string& campaign)
    : path_(absolute(runs) + "/" + campaign) {
  require(is_campaign_name(campaign), "campaign",
          "a campaign's name has only letters, digits and ._-");
}

std::optional<Plan> RunFolder::read_plan() const {
  const std::string file = path_ + "/campaign.json";
  const auto text = read_if_there(file);
  if (!text) {
    return std::nullopt;
  }
  const auto parsed = nlohmann::json::parse(*text, nullptr, false);
  require(!parsed.is_discarded(), file, "is not JSON");
  return plan_from_json(parsed, file);
}

void RunFolder::write_plan(const Plan& plan) const {
  make_folder(path_);
  for (const Ensemble& e : plan.ensembles) {
    make_folder(ensemble(e));
    write_whole(scene_file(e), e.scene.dump(2) + "\n", true);
  }
  write_whole(path_ + "/campaign.json", to_json(plan).dump(1) + "\n", true);
}

std::string RunFolder::ensemble(const Ensemble& ensemble) const {
  return fmt::format("{}/p{:04}-{}", path_, ensemble.point, ensemble.tier);
}

std::string RunFolder::realisation(const Plan& plan, const Item& item) const {
  return fmt::format("{}/{:06}", ensemble(plan.ensembles[item.ensemble]), item.index);
}

std::vector<int> RunFolder::started(const Ensemble& of) const {
  return numbered(ensemble(of), "");
}

std::vector<int> attempts_in(const std::string& realisation_folder) {
  return numbered(realisation_folder, "attempt-");
}

std::string attempt_folder(const std::string& realisation_folder, int number) {
  return fmt::format("{}/attempt-{:03}", realisation_folder, number);
}

std::vector<std::string> campaigns_in(const std::string& runs) {
  std::vector<std::string> names;
  for (const std::string& name : names_in(runs)) {
    const std::filesystem::path folder = std::filesystem::path(runs) / name;
    if (is_campaign_name(name) && std::filesystem::exists(folder / "campaign.json")) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace colloid
