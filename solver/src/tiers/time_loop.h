// One realisation from the first injection to its end.                   MODEL section P
//
// The loop is the same for every tier of this program; a tier brings the motion of the
// colloids and the flow around the deposit.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "core/random.h"
#include "io/checkpoint.h"
#include "particles/injection_sequence.h"
#include "particles/integrator.h"
#include "particles/motion.h"
#include "scene/scene.h"
#include "tiers/deposit_flow.h"
#include "tiers/growing_deposit.h"
#include "tiers/run_cost.h"
#include "tiers/run_options.h"
#include "tiers/run_record.h"
#include "tiers/run_state.h"
#include "tiers/surface_model.h"

namespace colloid {

/// What a tier hands to the loop.
struct LoopParts {
  DepositFlow& flow;
  FixedSurfaces& surfaces;
  MotionModel& motion;
  const SurfaceModel& contacts;
  InjectionPlan injections;
  double inlet_speed = 0.0;  ///< mean, of the clean pore [m/s]
  bool brownian = false;
  double step_tolerance = 1e-3;  ///< of the integrator
  std::string tier;
  std::string validity;  ///< the numbers by which the tier is valid for the scene
};

class TimeLoop {
 public:
  TimeLoop(const Scene& scene, const RunOptions& options, const LoopParts& parts);

  /// To the end; nothing if it was stopped, with a checkpoint written.
  std::optional<Realisation> run();

 private:
  void begin_with_bodies();
  void resume();
  void save();
  bool stopped();
  double next_injection_time();
  void step();
  bool inject(int index);
  void after_step();
  bool handle_touch();
  void handle_pushes(double step);
  bool handle_broken_bonds();
  void handle_exits();
  void handle_rest();
  void bond(RigidBody& body, const Touch& touch);
  void merge(const Contact& contact);
  void arrest(std::size_t body, std::size_t member);
  double escape_rate(double push) const;
  Forcing thermal_forcing(double longest) const;
  void record();
  NamedNumbers cost() const;
  void finish();

  const Scene& scene_;
  const RunOptions& options_;
  LoopParts parts_;
  double radius_;
  InjectionSequence sequence_;
  Random random_;
  Integrator integrator_;
  RunState state_;
  GrowingDeposit deposit_;
  RestRule rest_;
  int first_injected_ = 0;  ///< id of the first colloid that is injected
  std::vector<std::pair<double, double>> escape_rates_;  ///< push [N], rate [1/s]
  RunCost cost_;
  std::chrono::steady_clock::time_point last_checkpoint_;
  int idle_steps_ = 0;  ///< of no length, in a row
  bool over_ = false;
};

}  // namespace colloid
