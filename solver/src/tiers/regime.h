// The dimensionless numbers of a scene and the models they call for.      MODEL section D
#pragma once

#include <optional>

#include "physics/pair_analysis.h"
#include "physics/regime_numbers.h"
#include "scene/scene.h"

namespace colloid {

/// Speeds and sizes that the flow and the geometry give.
struct FlowScales {
  double inlet_speed = 0.0;      ///< superficial mean over the inlet [m/s]
  double throat_speed = 0.0;     ///< mean over the open part of the narrowest plane [m/s]
  double largest_speed = 0.0;    ///< anywhere [m/s]
  double throat_diameter = 0.0;  ///< critical diameter [m]
};

/// Open part of the narrowest plane normal to `axis` [m^2], sampled: planes every 1/400
/// of the length, 200 x 200 points each.
double narrowest_open_area(const Box& box, const std::vector<Sphere>& spheres, int axis);

/// What surface forces make of one pair type.
struct PairRegime {
  PairAnalysis analysis;
  // Infinite without flow: nothing then opposes the attraction.
  double capture_gap = 0.0;         ///< at the inlet's speed [m]
  double capture_gap_throat = 0.0;  ///< at the mean speed in the throat [m]
  double range = 0.0;  ///< of the interaction, at the inlet's Stokes drag [m]
};

/// Of a scene with colloids.
struct ColloidRegime {
  double reynolds_particle = 0.0;
  double stokes = 0.0;          ///< at the inlet's speed
  double stokes_largest = 0.0;  ///< at the largest speed, of the liquid or of settling
  double peclet = 0.0;          ///< at the inlet's speed, the smallest
  double settling_speed = 0.0;  ///< [m/s]
  double gravity_number = 0.0;
  double relaxation_time = 0.0;  ///< [s]
  double debye_length = 0.0;     ///< [m]
  PairRegime colloid_grain;
  PairRegime colloid_colloid;
  ModelDecisions models;
};

struct Regime {
  FlowScales scales;
  double reynolds_throat = 0.0;
  ModelDecision inertia;  ///< also a question of the flow alone
  std::optional<ColloidRegime> colloids;
};

Regime analyse_regime(const Scene& scene, const FlowScales& scales);

class DepositFlow;
/// Of the clean pore, with the flow already solved.
Regime regime_of(const Scene& scene, const DepositFlow& flow);

}  // namespace colloid
