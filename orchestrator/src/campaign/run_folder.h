// Where a campaign's files are.
//
//     <runs>/<campaign>/campaign.json             the plan
//     <runs>/<campaign>/lock                      held while an orchestrator works on it
//     .../p0000-one_way/scene.json                design point 0 in that tier
//     .../p0000-one_way/000012/checkpoint.h5      of realisation 12, for its next attempt
//     .../p0000-one_way/000012/attempt-001/       command, stdout, stderr, ending.json,
//                                                 lock (held while it runs), result.h5
//
// The folders are the truth and the database is made from them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/plan.h"

namespace colloid {

class RunFolder {
 public:
  RunFolder(const std::string& runs, const std::string& campaign);

  const std::string& path() const { return path_; }
  std::string lock_file() const { return path_ + "/lock"; }

  /// None if there is no such campaign.
  std::optional<Plan> read_plan() const;
  /// Writes the plan and the scenes, and waits for the disk.
  void write_plan(const Plan& plan) const;

  std::string ensemble(const Ensemble& ensemble) const;
  std::string scene_file(const Ensemble& of) const {
    return ensemble(of) + "/scene.json";
  }
  std::string realisation(const Plan& plan, const Item& item) const;

  /// Indices of an ensemble that have a folder, ascending.
  std::vector<int> started(const Ensemble& ensemble) const;

 private:
  std::string path_;
};

/// Numbers of the attempts in a realisation's folder, ascending.
std::vector<int> attempts_in(const std::string& realisation_folder);
std::string attempt_folder(const std::string& realisation_folder, int number);

/// Names of the campaigns in a folder of runs, sorted.
std::vector<std::string> campaigns_in(const std::string& runs);

}  // namespace colloid
