// What the energy curve of a pair type means for capture: minima, barrier, pull-off
// force, and the gaps at which the interaction equals a given hydrodynamic force.
//
// The curve is sampled on a grid uniform in ln h from the pair's closest gap outwards,
// its local extrema are refined by Brent's method and its roots by TOMS 748, so two roots
// of the force are separated also where they almost merge.  Once per pair type; takes
// about a millisecond.
#pragma once

#include <optional>
#include <vector>

#include "physics/surface_pair.h"

namespace colloid {

/// A gap at which the force vanishes, or the closest gap if the surfaces are pulled on
/// it.
struct StationaryPoint {
  enum class Kind { minimum, maximum };
  Kind kind = Kind::minimum;
  double gap = 0.0;        ///< h [m]
  double energy = 0.0;     ///< E [J], zero at infinite gap
  double energy_kT = 0.0;  ///< E / (k_B T) [-]
};

/// A force and the gap at which it acts.
struct ForceAtGap {
  double force = 0.0;  ///< [N]
  double gap = 0.0;    ///< [m]
};

/// MODEL (S10)-(S13).
struct PairAnalysis {
  /// All of them, from far to near.
  std::vector<StationaryPoint> stationary_points;

  /// The deepest minimum inside the barrier.  Without a barrier the only minimum is the
  /// primary one if Born repulsion holds it up, the secondary one if the double layer
  /// does. No value: the surfaces cannot attach.
  std::optional<StationaryPoint> primary_minimum;
  /// The highest maximum, if something attracts inside it.
  std::optional<StationaryPoint> barrier;
  /// The deepest minimum outside the barrier.
  std::optional<StationaryPoint> secondary_minimum;

  /// Energy that a surface coming from infinity must find to reach the primary minimum
  /// (or the closest gap, if there is none) [kT]; 0 = favourable.
  double barrier_from_outside_kT = 0.0;
  /// The same from the secondary minimum; equal to the above where there is none.
  double barrier_from_secondary_kT = 0.0;

  /// Largest repulsion to be overcome on the way in: force 0 = none.
  ForceAtGap largest_repulsion;
  /// Largest attraction between the minimum and the barrier, or infinity, as a positive
  /// force: what tears the pair apart.
  ForceAtGap primary_pull_off;
  ForceAtGap secondary_pull_off;
};

PairAnalysis analyse_pair(const SurfaceForces& forces);

/// Largest gap [m] at which the pair attracts with `force` [N] or more; 0 = nowhere. With
/// the Stokes drag 6 pi mu a U for `force` this is the physical capture gap, MODEL (S14).
/// Where a barrier is higher than the drag it lies inside the barrier.
double capture_gap(const SurfaceForces& forces, double force);

/// The same of the van der Waals force alone; unretarded: sqrt(A R / (6 F)).
double van_der_waals_capture_gap(const SurfaceForces& forces, double force);

/// Range of the interaction: largest gap [m] at which its force, of either sign, is
/// `force` [N] or more; 0 = nowhere.
double interaction_range(const SurfaceForces& forces, double force);

}  // namespace colloid
