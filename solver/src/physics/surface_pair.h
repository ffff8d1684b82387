// The whole surface interaction (extended DLVO) of one pair type: colloid and grain
// (sphere and plate), or two colloids (two spheres).
#pragma once

#include "physics/double_layer.h"
#include "physics/electrolyte.h"
#include "physics/van_der_waals.h"

namespace colloid {

enum class PairShape { sphere_plate, two_spheres };
enum class DoubleLayerForm { constant_potential, superposition };
enum class VanDerWaalsForm { unretarded, retarded };

/// What a scene says about one pair type.  Defaults: colloid and grain of the reference.
struct SurfacePair {
  PairShape shape = PairShape::sphere_plate;
  double radius = 6.65e-6;        ///< a [m]
  double other_radius = 6.65e-6;  ///< b [m], two spheres only
  double zeta = -27.9e-3;         ///< psi_1 [V]
  double other_zeta = -15.7e-3;   ///< psi_2 [V]
  double hamaker = 1e-20;         ///< A [J]
  double born_diameter = 0.5e-9;  ///< sigma [m]; 0 switches the Born term off
  double closest_gap = 0.158e-9;  ///< [m] surfaces never come closer, Born term or not
  double wavelength = 100e-9;     ///< lambda [m] of retardation
  DoubleLayerForm double_layer = DoubleLayerForm::constant_potential;
  VanDerWaalsForm van_der_waals = VanDerWaalsForm::unretarded;
  Electrolyte electrolyte;
};

/// Energy and force at a gap.  Finite for every gap from 1e-15 m to 1 m and every pair
/// that the constructor accepts; it refuses what is not a number, and radii,
/// temperatures, permittivities, ionic strengths and gaps that are not positive.
class SurfaceForces {
 public:
  explicit SurfaceForces(const SurfacePair& pair);

  /// [J], zero at infinite gap, MODEL (S9): double layer + van der Waals + Born.
  double energy(double gap) const;
  /// -dE/dh [N], positive = repulsive.
  double force(double gap) const;

  double double_layer_energy(double gap) const;
  double double_layer_force(double gap) const;
  double van_der_waals_energy(double gap) const;
  double van_der_waals_force(double gap) const;
  double born_energy(double gap) const;
  double born_force(double gap) const;

  const SurfacePair& pair() const { return pair_; }
  double debye_length() const { return double_layer_.debye_length; }  ///< [m]
  double thermal_energy() const { return thermal_energy_; }           ///< k_B T [J]
  double derjaguin_radius() const { return double_layer_.radius; }    ///< R [m]

 private:
  SurfacePair pair_;
  DoubleLayerTerm double_layer_;
  Dispersion dispersion_;
  double thermal_energy_;
};

}  // namespace colloid
