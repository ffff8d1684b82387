// What every time loop does alike: it records its state, lets colloids enter, and tells
// which have come to rest.
#pragma once

#include <chrono>
#include <functional>

#include "particles/injection_sequence.h"
#include "particles/surfaces.h"
#include "scene/scene.h"
#include "tiers/growing_deposit.h"
#include "tiers/run_state.h"

namespace colloid {

double seconds_since(std::chrono::steady_clock::time_point start);

/// Of the series and of the trajectories [s].
double next_output_time(const RunState& state, double duration);

/// Appends a row to the series and a frame to the trajectories.  `permeability` now
/// [m^2]; `first_injected`: id of the first colloid that is injected.
void record_output(RunState& state, const GrowingDeposit& deposit, double permeability,
                   int first_injected, double radius);

/// The end: duration, ending, final counts and, unless there is one, a last output.
void record_end(RunState& state, const Scene& scene, const GrowingDeposit& deposit,
                double permeability, int first_injected);

/// The colloid of the sequence whose turn it is; `inject` (an index in the sequence) is
/// false if something is in the way: it then waits.
void inject_next(RunState& state, InjectionSequence& sequence, int first_injected,
                 const std::function<bool(int)>& inject);
/// Those that wait, in order.
void inject_waiting(RunState& state, const std::function<bool(int)>& inject);

/// Whether no mobile or retained colloid has its centre within `distance` of `position`
/// [m].
bool has_room(const RunState& state, const FixedSurfaces& surfaces, const Vec3& position,
              double distance);

/// Slow for as long as it would take to go 1 % of a radius at the limiting speed.
class RestRule {
 public:
  /// `inlet_speed`: mean, of the clean pore [m/s].
  RestRule(double inlet_speed, double radius);

  double travel() const { return travel_; }  ///< [m]
  /// Whether `body` has come to rest; keeps in it since when and where it is slow.
  /// `held`: tied to the deposit or wedged; `speed`: of its fastest colloid [m/s].
  bool at_rest(RigidBody& body, bool held, double speed, double time) const;

 private:
  double limit_;   ///< [m/s]
  double travel_;  ///< [m]
};

}  // namespace colloid
