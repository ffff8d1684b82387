// The discrete elements of rank 0, with their answers on every rank.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tiers/transient/dem.h"

namespace colloid {

/// As Dem, on every rank: only rank 0 computes.  Its errors are thrown on all.
class SharedDem {
 public:
  SharedDem(const DemOptions& options, const std::vector<Sphere>& grains);

  void add(const DemState& state);
  void remove(int id);
  void hold(int id);
  DemStep advance(double duration, const std::vector<DemLoad>& loads);

  const std::vector<DemState>& states() const { return states_; }
  const std::vector<DemBond>& bonds() const { return bonds_; }
  long bonds_broken() const { return broken_; }

  std::string save();
  void restore(const std::string& saved);

 private:
  template <class Action>
  void on_first_rank(const Action& action);
  void share();

  std::unique_ptr<Dem> dem_;  // on rank 0
  std::vector<DemState> states_;
  std::vector<DemBond> bonds_;
  long broken_ = 0;
};

}  // namespace colloid
