// Sub-grid lubrication, solved together with the drag.                    MODEL (T-D5)
#pragma once

#include <vector>

#include "core/vec3.h"

namespace colloid {

/// Wider gaps, in cells, are the flow's alone.
constexpr double kResolvedGap = 3.0;

/// What a flow on cells of the edge d resists with at the gap x d, over 6 pi mu R^2/d:
/// measured, MODEL (T9).  1/x from kResolvedGap on.
double resolved_resistance(double x);

/// Resistance to approach [N s/m] at the gap h of surfaces of reduced radius R that a
/// flow on cells of the edge d leaves: 6 pi mu R^2 (1/h - resolved_resistance(h/d)/d),
/// constant below `floor`.
double lubrication_resistance(double viscosity, double reduced_radius, double gap,
                              double cell, double floor);

/// One narrow gap.  Slots: where a colloid's velocity is in the arrays; -1: at rest.
struct NarrowGap {
  int first = -1;
  int second = -1;
  Vec3 normal;              ///< unit, from the second to the first
  double resistance = 0.0;  ///< [N s/m]
  double force = 0.0;       ///< result: on the first along the normal [N]
};

/// Velocities that obey, for every colloid and gap,
///
///     D (v - v_0) = sum of +- force n,   force = -resistance n . (v_first - v_second)
///
/// where v_0 is what `velocity` holds on entry, and D what `inertia` holds [N s/m]:
/// sweeps over the gaps until no force changes.  ConvergenceError if that does not
/// happen.
void solve_lubrication(std::vector<NarrowGap>& gaps, const std::vector<double>& inertia,
                       std::vector<Vec3>& velocity);

}  // namespace colloid
