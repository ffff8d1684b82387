// One realisation of the tier transient, from the first injection to its end.
//                                                                        MODEL section T
//
// A flow step finds the motion of fluid and free colloids together; the discrete elements
// then move the colloids through it in many sub-steps, the flow's force linearised around
// its answer; the mean of all other forces goes into the next flow step.
#pragma once

#include <chrono>
#include <map>
#include <optional>

#include "io/checkpoint.h"
#include "particles/injection_sequence.h"
#include "scene/scene.h"
#include "tiers/deposit_flow.h"
#include "tiers/growing_deposit.h"
#include "tiers/injection.h"
#include "tiers/regime.h"
#include "tiers/run_cost.h"
#include "tiers/run_options.h"
#include "tiers/run_record.h"
#include "tiers/run_state.h"
#include "tiers/surface_model.h"
#include "tiers/transient/shared_dem.h"
#include "tiers/transient/transient_flow.h"

namespace colloid {

class TransientLoop {
 public:
  /// On every rank.  InputError: a scene that this tier cannot compute.
  TransientLoop(const Scene& scene, const RunOptions& options);

  /// To the end; nothing if it was stopped, with a checkpoint written.
  std::optional<Realisation> run();

 private:
  struct Mean {
    Vec3 force, torque;
  };

  void begin();
  void resume();
  void save();
  bool stopped();
  double step_length(double until) const;
  void step();
  void move(double dt);
  std::vector<FlowBody> flow_bodies(double dt) const;
  DemLoad load_of(int id, const FlowResponse& response) const;
  void take_states();
  void handle_events(const std::vector<DemEvent>& events);
  void handle_exits();
  void handle_rest();
  bool inject(int index);
  void insert(const MobileColloid& colloid, const Vec3& position, const Vec3& velocity);
  void arrest(int id, double time);
  void record();
  void finish();

  std::size_t place_of(int id) const;
  RigidBody aggregate_of(int id) const;
  Vec3 weight() const;
  double next_injection_time();

  const Scene& scene_;
  const RunOptions& options_;
  double radius_;
  CleanInlet inlet_;
  InjectionSequence sequence_;
  DepositFlow deposit_flow_;  ///< Stokes flow around the deposit alone: k(t)
  Regime regime_;
  SurfaceModel contacts_;
  FixedSurfaces surfaces_;
  GrowingDeposit deposit_;
  RestRule rest_;
  TransientFlow flow_;
  SharedDem dem_;
  RunState state_;             ///< bodies: one a colloid, also where DEM joins several
  std::map<int, Mean> means_;  ///< by id: what is not the flow's, over the last interval
  std::map<int, Mean> loads_;  ///< by id: the flow's, in the last step
  int first_injected_ = 0;
  long dem_steps_ = 0;
  RunCost cost_;
  std::chrono::steady_clock::time_point last_checkpoint_;
  bool over_ = false;
};

}  // namespace colloid
