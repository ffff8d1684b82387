// Decides, ensemble by ensemble, whether a campaign's target (campaign/target.h) is met
// and how many realisations are wanted meanwhile.
//
// A decision is taken when the first `pilot`, then `pilot + batch`, ... realisations in
// seed order have all ended, and at last when all have.  Nothing beyond the next decision
// is wanted before it has been taken: so what is run, and where it stops, depend on the
// seeds alone, not on the number of workers, on which runs took long, or on kills (the
// decisions are taken again from the database, with the same results).  Workers that find
// nothing to do meanwhile are the price; a batch of several times their number keeps it
// low.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"
#include "campaign/target.h"
#include "store/database.h"

namespace colloid {

/// How far an ensemble has got with the target.
struct TargetState {
  int next_look = 0;  ///< realisations that decide next; 0: all decisions are taken
  int looks = 0;      ///< decisions taken
  int seen = 0;       ///< realisations at the last decision
  std::optional<double> half_width;  ///< at the last decision
  bool met = false;                  ///< at the last decision
};

class TargetWatch {
 public:
  /// Takes the decisions that the database allows.
  TargetWatch(const Plan& plan, const Database& database);

  /// Takes those that have become due.  If more realisations are wanted now, the first
  /// index that was not before.
  std::optional<int> look(const Database& database);

  /// How many realisations of an ensemble, in seed order, are to be run for now.
  int wanted(std::size_t ensemble) const;
  /// Have all decisions been taken, of all ensembles, and is one of them against it?
  bool is_missed() const;
  bool has_target() const { return target_.has_value(); }
  const TargetState& state(std::size_t ensemble) const { return states_[ensemble]; }

  /// For statistics.json and --json; null without a target.
  nlohmann::ordered_json json(std::size_t ensemble) const;
  /// A line for people; empty without a target.
  std::string text(std::size_t ensemble) const;

 private:
  void look(const Database& database, std::size_t ensemble);

  const Plan& plan_;
  std::optional<Target> target_;
  std::vector<TargetState> states_;  ///< by ensemble
};

}  // namespace colloid
