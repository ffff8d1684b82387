// How surfaces nearby slow a colloid down.                              MODEL (P2)-(P7)
//
// Every near surface acts as if it were alone with the colloid; their effects are added,
// less what they shield each other from:
//
//     R = R_0 + sum w_s (R_s - R_0) + shielding,   D = R (u, a w) + sum w_s B_s
//
// R_s resists the motion of the colloid beside the held surface; B_s is what the shape of
// the ambient flow does to the held colloid beyond carrying it along.  Units:
// small_matrix.h.
#pragma once

#include <map>
#include <vector>

#include "particles/ambient_flow.h"
#include "particles/shielding.h"
#include "particles/small_matrix.h"
#include "particles/surfaces.h"
#include "physics/pair_in_strain.h"
#include "physics/pair_resistance.h"
#include "physics/stream_past_sphere.h"

namespace colloid {

/// Resistance to a colloid's motion and the ambient flow's wrench on it when held.
struct HeldColloid {
  Matrix6 resistance = Matrix6::Zero();
  Vector6 drive = Vector6::Zero();
  std::vector<WideSurface> wide;  ///< which shield each other
};

/// Far from everything: Stokes' resistance, nothing that drives.
HeldColloid isolated();

/// After all surfaces were added: what they shield each other from, and the drive of the
/// ambient velocity and spin.
void let_shield_and_carry(const AmbientMotion& ambient, double radius, HeldColloid& held);

/// Hindrance by fixed surfaces.
class SurfaceHindrance {
 public:
  /// `radius` a of the colloid [m]; `sphere_radii`: every radius that may come near.
  /// Refuses spheres smaller than a/20, for which there is no resistance function.
  SurfaceHindrance(double radius, const std::vector<double>& sphere_radii);

  /// Adds what one surface does.  `least_gap` [m] takes the place of smaller gaps, which
  /// occur only in steps that are tried and thrown away.  Faces that are no walls must be
  /// left out by the caller.
  void add(const NearSurface& surface, double least_gap, const AmbientMotion& ambient,
           HeldColloid& held) const;

 private:
  struct Neighbour {
    explicit Neighbour(double ratio);
    TwoSphereResistance resistance;
    StreamPastSphere stream;
  };

  double radius_;
  std::map<double, Neighbour> neighbours_;  ///< by radius [m]
};

/// How two equal mobile colloids act on each other, MODEL (P5): the force along their
/// line of centres on sphere 1 is -1/2 (squeeze V - drive v), V and v the approach of the
/// spheres and of the ambient flow; across it they follow the strain only in part.
struct PairHindrance {
  double squeeze = 0.0;  ///< Lambda [-]
  double drive = 0.0;    ///< D [-]
  double shear = 0.0;    ///< B of Batchelor & Green [-]
};

/// `gap_over_radius` = h/a > 0.
class EqualPairHindrance {
 public:
  EqualPairHindrance() : resistance_(1.0) {}
  PairHindrance at(double gap_over_radius) const;
  const TwoSphereResistance& resistance() const { return resistance_; }

 private:
  TwoSphereResistance resistance_;
  PairInStrain strain_;
};

/// Spheres act up to this gap over a, with a weight that falls from 1 at half of it.
constexpr double kHindranceReach = 4.0;
double hindrance_weight(double gap_over_radius);
/// The same as a distance from the surface to the colloid's centre: what FixedSurfaces
/// must reach, or hindrance would set in with a jump [m].
inline double hindrance_range(double radius) {
  return (1.0 + kHindranceReach) * radius;
}

}  // namespace colloid
