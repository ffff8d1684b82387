// Folds what attempts left in their folders into the database: the one place where a
// realisation's status is decided.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "campaign/attempt_watch.h"
#include "campaign/plan.h"
#include "campaign/run_folder.h"
#include "store/store.h"

namespace colloid {

/// An attempt of a realisation.
struct AttemptOf {
  Item item;
  int number = 0;
};

/// Where an ended attempt leaves its realisation, and why it ended.
struct Settled {
  Status status = Status::eligible;
  Cause cause = Cause::lost;
};

class Ingester {
 public:
  /// `watch`: who knows of attempts that run elsewhere; null if none do.
  Ingester(Store& store, const RunFolder& folder, const Plan& plan,
           AttemptWatch* watch = nullptr)
      : store_(store), folder_(folder), plan_(plan), watch_(watch) {}

  /// Brings the database up to what is in the folders, whoever left it there and however
  /// that process ended.  Returns the attempts that are running now.
  std::vector<AttemptOf> catch_up();

  /// The same for one attempt that has ended.  `command`: if the caller knows it, so that
  /// it need not be read.
  Settled settle(const Item& item, int number, const std::string& command = "");

 private:
  void catch_up(const Item& item, std::vector<AttemptOf>& running);
  /// Where an attempt without a recorded end is; one that is lost gets an ending.
  Presence presence(const std::string& folder);
  /// The status that the ended attempts leave a realisation in that is not ingested.
  Status standing_of(const Item& item);
  /// Why the result is not that of the realisation; empty if it is.
  std::string foreign(const Item& item, const ResultRecord& result);
  std::string scene_hash_of(const std::string& scene, bool without_tier);

  Store& store_;
  const RunFolder& folder_;
  const Plan& plan_;
  AttemptWatch* watch_;
  std::string last_scene_;
  std::string last_scene_hash_;
};

}  // namespace colloid
