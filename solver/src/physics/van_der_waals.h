// Van der Waals interaction of a sphere and a plate, or of two spheres.
//
// The Hamaker constant may have either sign (a negative one repels).  Energy in J and
// force in N, positive = repulsive, F = -dE/dh.
#pragma once

#include <limits>

namespace colloid {

struct Dispersion {
  double hamaker = 0.0;  ///< A [J]
  double radius = 0.0;   ///< a [m]
  /// b [m]; infinite = a plate.
  double other_radius = std::numeric_limits<double>::infinity();
  double wavelength = 100e-9;  ///< lambda [m], of the retarded forms only
};

/// Any gap, MODEL (S4):
///
///     E = -(A/6) [ (u/2) (1 + 1/(1-u)) + ln(1-u) ],     F = -(A/12) (u/(1-u))^2 |du/dh|
///
/// with u = 4ab / ((h+2a)(h+2b)) for two spheres and u = 2a / (h+2a) for a sphere and a
/// plate.  At h << a it is -A R / (6 h), R = a b / (a + b).
/// Source: Hamaker (1937), Physica 4, 1058; his three terms with two of them collected.
double unretarded_energy(const Dispersion& pair, double gap);
double unretarded_force(const Dispersion& pair, double gap);

/// Retarded: (S4) times Gregory's factor r(h), MODEL (S5) for a sphere and a plate, (S6)
/// for two spheres:
///
///     r = 1 / (1 + 14 h / lambda),     r = 1 - y ln(1 + 1/y), y = 5.32 h / lambda
///
/// Source: Gregory (1981), J. Colloid Interface Sci. 83, 138, who gives r with the limit
/// h << a of (S4); the spheres' r is Derjaguin's integral of his flat-plate energy
/// -A / (12 pi h^2 (1 + y)).  With all of (S4) the retarded force of a small sphere stays
/// below the unretarded one also where h is not small against a.
double retarded_plate_energy(const Dispersion& pair, double gap);
double retarded_plate_force(const Dispersion& pair, double gap);
double retarded_spheres_energy(const Dispersion& pair, double gap);
double retarded_spheres_force(const Dispersion& pair, double gap);

}  // namespace colloid
