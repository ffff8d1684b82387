// What a deposit does to a realisation as it grows: surfaces, passage, flow, and the
// times t_1 and t_c.                                                        MODEL (P9),
// (P14)
#pragma once

#include <vector>

#include "io/checkpoint.h"
#include "observe/critical_diameter.h"
#include "particles/surfaces.h"
#include "scene/scene.h"
#include "tiers/deposit_flow.h"
#include "tiers/run_state.h"

namespace colloid {

class GrowingDeposit {
 public:
  /// The clean pore of `scene`, with the flow through it and its surfaces, both of which
  /// grow with the deposit.
  GrowingDeposit(const Scene& scene, DepositFlow& flow, FixedSurfaces& surfaces);

  /// Retains `colloids` (of one body, in order) at `time` [s]: in the records of `state`,
  /// as surfaces, and in the flow, which is solved again.  The spheres that are new.
  std::vector<Sphere> add(std::vector<RetainedColloid> colloids, double time,
                          RunState& state);

  const CriticalDiameter& critical() const { return critical_; }
  double first_permeability() const { return first_permeability_; }  ///< clean [m^2]

  /// Whether it has clogged the pore, where the scene ends then.
  bool ends_run(const Realisation& realisation) const;

  void save(Checkpoint& checkpoint) const;
  /// `state` as it was saved.  The deposit grows again as it did, so that everything
  /// built from it is the same to the bit; only the solves are left out.
  void restore(const Checkpoint& checkpoint, const RunState& state);

 private:
  void observe(const DepositBatch& batch);

  const Scene& scene_;
  DepositFlow& flow_;
  FixedSurfaces& surfaces_;
  double radius_;
  CriticalDiameter critical_;
  std::vector<Sphere> spheres_;  ///< grains and deposit
  double first_permeability_;
};

}  // namespace colloid
