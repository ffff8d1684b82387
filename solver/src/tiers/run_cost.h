// What a run costs, over all the times it was stopped and went on.
#pragma once

#include "flow/clock.h"
#include "io/realisation.h"

namespace colloid {

class RunCost {
 public:
  /// Goes on from a checkpoint: `before` is what it had cost when that was written.
  void resume(NamedNumbers before) { before_ = std::move(before); }

  /// Wall and processor time [s] and `more`, each with what `before` has of that name.
  NamedNumbers so_far(const NamedNumbers& more = {}) const;

 private:
  NamedNumbers before_;
  double wall_ = wall_seconds();
  double processor_ = processor_seconds();
};

}  // namespace colloid
