// What a flow solved on a grid leaves out of the resistance in narrow gaps.  MODEL (Q2)
//
// The exact resistance at the gap less that at the gap the grid takes it for: normal,
// tangential and rotational, of the motion relative to the other surface.
#pragma once

#include <cmath>

#include "core/box.h"
#include "particles/hindrance.h"
#include "particles/small_matrix.h"
#include "particles/unresolved_gap_coefficients.h"
#include "physics/pair_resistance.h"

namespace colloid {

/// Gaps of more cells are resolved by the grid.
constexpr double kResolvedCells = 5.0;

/// The gap [cells] at which the exact force of two surfaces that approach or slide is
/// that which the flow solver finds at `gap` [cells]: wider by a fifth of a cell near
/// contact, by less than a hundredth beyond three.  Calibrated, and its error measured,
/// by scripts/calibrate_lubrication.py (results/evidence/lubrication).
inline double gap_seen_by_grid(double gap) {
  return gap + kGapWidening * std::exp(-gap / kGapRange);
}
/// The same of the torques of spins, and of the forces that spins make.
inline double gap_seen_by_turning(double gap) {
  return gap + kGapWideningTurning * std::exp(-gap / kGapRangeTurning);
}
inline double gap_seen_by_coupling(double gap) {
  return gap + kGapWideningCoupling * std::exp(-gap / kGapRangeTurning);
}

/// Gaps whose exact resistance is that which a grid finds [m].
struct SeenGap {
  double force = 0.0;     ///< of forces by motion
  double torque = 0.0;    ///< of torques by spin
  double coupling = 0.0;  ///< of forces by spin
};

/// Resistance at `gap` less that at `seen`, of a sphere of `radius` [m] beside a fixed
/// surface; units of small_matrix.h.
Matrix6 lost_beside(const SurfaceHindrance& hindrance, const NearSurface& surface,
                    double radius, double gap, const SeenGap& seen);

/// The same by the grid of the width `cell` [m].  Smaller gaps count as `least_gap`.
Matrix6 unresolved_beside(const SurfaceHindrance& hindrance, const NearSurface& surface,
                          double radius, double least_gap, double cell);

/// Resistance at `gap` less that at `seen` [m], of two spheres that both move, `pair`
/// made for the ratio of their radii: their wrenches over mu against (U_1, w_1, U_2, w_2)
/// in m and s, about their centres.  One gap for all: sliding in a gap of two spheres
/// resists neither of them alone but the slip between them, and only with equal
/// logarithms is rolling left free.
Matrix12 lost_between(const TwoSphereResistance& pair, const Sphere& one,
                      const Sphere& two, double gap, double seen);

/// The same by the grid of the width `cell` [m].  Smaller gaps count as `least_gap`.
Matrix12 unresolved_between(const TwoSphereResistance& pair, const Sphere& one,
                            const Sphere& two, double least_gap, double cell);

}  // namespace colloid
