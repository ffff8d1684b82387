// Electric double-layer interaction of two curved surfaces at a small gap.
//
// Both forms rest on Derjaguin's approximation: curvature enters only through the radius
//
//     R = a (sphere and plate),     R = a b / (a + b) (spheres of radii a and b),
//
// so one function serves both geometries.  Small potentials (up to about 60 mV for the
// constant-potential form, Hogg et al.), 1:1 electrolyte, kappa R >> 1, gap << R.
// Potentials may have any sign and may be zero.  Energy in J, positive = repulsive; force
// in N, positive = repulsive, F = -dE/dh.
#pragma once

namespace colloid {

struct DoubleLayerTerm {
  double radius = 0.0;        ///< Derjaguin radius R [m]
  double potential_1 = 0.0;   ///< psi_1 [V], the zeta potential is taken for it
  double potential_2 = 0.0;   ///< psi_2 [V]
  double permittivity = 0.0;  ///< eps [F/m]
  double debye_length = 0.0;  ///< 1/kappa [m]
};

/// Surfaces of constant potential, MODEL (S2), with x = exp(-kappa h):
///
///     E = pi eps R [ (psi_1 + psi_2)^2 ln(1 + x) + (psi_1 - psi_2)^2 ln(1 - x) ]
///
/// This is Hogg, Healy & Fuerstenau (1966), Trans. Faraday Soc. 62, 1638, eq. (29), with
/// ln((1 + x)/(1 - x)) and ln(1 - x^2) collected so that nothing cancels.  For psi_1 =
/// psi_2 = psi and equal spheres it is Derjaguin's 2 pi eps a psi^2 ln(1 + x).  Unequal
/// potentials attract at small gaps, whatever their signs.
double constant_potential_energy(const DoubleLayerTerm& pair, double gap);
double constant_potential_force(const DoubleLayerTerm& pair, double gap);

/// Linear superposition of the two undisturbed layers, MODEL (S3):
///
///     E = 4 pi eps R psi_1 psi_2 exp(-kappa h)
///
/// Source: Bell, Levine & McCartney (1970), J. Colloid Interface Sci. 33, 335, at small
/// potentials and h << R.  Equal spheres: 2 pi eps a psi^2 exp(-kappa h).
double superposition_energy(const DoubleLayerTerm& pair, double gap);
double superposition_force(const DoubleLayerTerm& pair, double gap);

}  // namespace colloid
