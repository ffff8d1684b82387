// Sub-grid lubrication, solved together with the drag.              MODEL (T-D5), (T10)
#pragma once

#include <vector>

#include <Eigen/Core>

#include "particles/hindrance.h"
#include "particles/small_matrix.h"
#include "physics/pair_resistance.h"

namespace colloid {

/// Wider gaps, in cells, are the flow's alone.
constexpr double kResolvedGap = 3.0;

/// What a flow on cells of the edge d resists with at the gap x d, over 6 pi mu R^2/d:
/// measured, MODEL (T9).  1/x from kResolvedGap on.
double resolved_resistance(double x);

/// What a gap that closes is taken for where a sphere slides or turns, beside a plane on
/// the grid and beside a sphere that is cut by it: measured, MODEL (T10) [cells].
constexpr double kSeenBesidePlane = 0.43;
constexpr double kSeenBesideSphere = 0.33;
/// The gap [cells] at which the exact resistance is that which a flow finds at the gap x,
/// `closed` one of those.
double gap_seen_by_sliding(double x, double closed);

/// Resistance to approach [N s/m] at the gap h of surfaces of reduced radius R that a
/// flow on cells of the edge d leaves: 6 pi mu R^2 (1/h - resolved_resistance(h/d)/d),
/// constant below `floor`.
double lubrication_resistance(double viscosity, double reduced_radius, double gap,
                              double cell, double floor);

/// Resistance that a flow leaves, of colloids of one radius in narrow gaps: against
/// (v, a w) of the one or of both, as (F, T/a) [N s/m].
class GapResistance {
 public:
  /// `cell`: edge of the flow's cells; smaller gaps than `floor` count as that; lengths
  /// in m.  Refuses grains smaller than a/20, for which there are no resistance
  /// functions.
  GapResistance(double viscosity, double radius, const std::vector<double>& grain_radii,
                double cell, double floor);

  /// Beside a surface at rest.
  Matrix6 beside(const NearSurface& surface) const;
  /// Of two colloids; `offset` from the second's centre to the first's.
  Matrix12 between(const Vec3& offset) const;

 private:
  double along(double reduced_radius, double gap) const;
  double seen(double gap, double closed) const;

  double viscosity_, radius_, cell_, floor_;
  SurfaceHindrance surfaces_;
  TwoSphereResistance colloids_;
};

using Vector12 = Eigen::Matrix<double, 12, 1>;

/// One narrow gap, of a colloid and a surface, or of two colloids.  Slots: where a
/// colloid's motion is in the arrays; -1: at rest, or none.
struct NarrowGap {
  int first = -1;
  int second = -1;
  bool pair = false;    ///< two colloids; else the upper left blocks alone count
  Matrix12 resistance;  ///< [N s/m]
  Vector12 drive;       ///< (F, T/a) on those at rest, by a wall that moves [N]
  Vector12 wrench;      ///< result: (F, T/a) on both [N]
};

NarrowGap narrow_gap(int colloid, const Matrix6& resistance);
NarrowGap narrow_gap(int first, int second, const Matrix12& resistance);

/// Motions (v, a w) that obey, for every colloid and gap,
///
///     V = V_0 + C (sum of wrenches),   wrench = drive - resistance (V_first, V_second)
///
/// where V_0 is what `motion` holds on entry, and C the diagonal that `compliance` holds
/// [m/(N s)]: sweeps over the gaps until no wrench changes.  ConvergenceError if that
/// does not happen.
void solve_lubrication(std::vector<NarrowGap>& gaps,
                       const std::vector<Vector6>& compliance,
                       std::vector<Vector6>& motion);

}  // namespace colloid
