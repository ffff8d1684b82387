// Runs of the tier one_way that start from colloids placed by hand: a checkpoint of that
// state is written and resumed, so everything after it is the program's own.
#pragma once

#include <utility>
#include <vector>

#include "io/checkpoint.h"
#include "temporary_folder.h"
#include "tiers/flow_problem.h"
#include "tiers/one_way.h"
#include "tiers/run_state.h"
#include "tiers/time_loop.h"

namespace colloid::cases {

constexpr int kFirstDeposit = 1000;  // id of the first colloid of the deposit

/// Where a run begins.
struct Start {
  std::vector<RigidBody> bodies;
  std::vector<Vec3> deposit;  ///< centres of colloids retained before [m]
};

inline RigidBody released_at(const Vec3& x, int id = 0) {
  MobileColloid colloid;
  colloid.id = id;
  colloid.injection_time = 0.0;
  colloid.injection_position = x;
  return single(colloid, x);
}

inline Realisation run_from(const Scene& scene, const Start& start,
                            std::uint64_t seed = 1) {
  const TemporaryFolder folder;
  DepositFlow flow(scene, choose_cells(scene, {}), 1);
  RunState state;
  state.bodies = start.bodies;
  int id = kFirstDeposit;
  const double first_permeability = flow.permeability();
  for (const Vec3& centre : start.deposit) {
    state.deposit.push_back({{id++}, {{centre, 0.5 * scene.colloids->diameter}}});
    flow.add(state.deposit.back().spheres);
  }
  Checkpoint checkpoint;
  checkpoint.identity = run_identity(scene, seed, "one_way");
  checkpoint.realisation.seed = seed;
  checkpoint.realisation.tier = "one_way";
  pack(state, checkpoint.reals, checkpoint.integers);
  checkpoint.reals["deposit_flow"] = flow.state();
  checkpoint.reals["motion"] = {};
  checkpoint.reals["first_permeability"] = {first_permeability};
  checkpoint.integers["deposit_flow_counts"] = {flow.solves(), flow.iterations(), 0};
  RunOptions options;
  options.seed = seed;
  options.checkpoint = folder.file("start.checkpoint");
  write_checkpoint(options.checkpoint, checkpoint);
  return run_one_way(scene, options).value();
}

/// A box of 60 x 60 x 90 um with side walls, flow downwards at 0.5 mm/s, colloids of
/// 6 um that only come from `Start`, no gravity, one grain of 30 um in the middle.
inline Scene one_grain_scene() {
  Scene scene;
  scene.geometry.box.size = {60e-6, 60e-6, 90e-6};
  scene.geometry.box.faces = {FaceCondition::wall,   FaceCondition::wall,
                              FaceCondition::wall,   FaceCondition::wall,
                              FaceCondition::outlet, FaceCondition::inlet};
  scene.geometry.spheres = {{{30e-6, 30e-6, 35e-6}, 15e-6}};
  scene.drive.inlet_velocity = 0.5e-3;
  scene.colloids = Colloids{};
  scene.colloids->diameter = 6e-6;
  scene.colloids->volume_fraction = 1e-12;
  scene.gravity = {};
  scene.duration = 2.0;
  scene.fidelity.cells_per_colloid = 2.5;
  scene.fidelity.capture_gap = 20e-9;
  return scene;
}

}  // namespace colloid::cases
