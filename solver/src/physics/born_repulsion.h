// Born repulsion: what keeps two surfaces from touching.
#pragma once

namespace colloid {

/// A sphere of radius a and a plate, MODEL (S7):
///
///     E = (|A| sigma^6 / 7560) [ (8a + h)/(2a + h)^7 + (6a - h)/h^7 ]
///
/// Energy [J] and force -dE/dh [N].  sigma [m] is the collision parameter, 0 = no Born
/// term; the sum is positive for h < 6 a and negligible beyond.  |A|: repulsive also
/// where the van der Waals force is (A < 0).  Source: Ruckenstein & Prieve (1976), AIChE
/// J. 22, 276 (the twelfth power of a Lennard-Jones potential, summed over both bodies).
double born_plate_energy(double hamaker, double sigma, double radius, double gap);
double born_plate_force(double hamaker, double sigma, double radius, double gap);

/// Two spheres, MODEL (S8): half the plate's term at radius 2R, R = a b / (a + b), which
/// is half the plate's term at a for equal spheres.  Exact in the limit h << R
/// (Derjaguin).
double born_spheres_energy(double hamaker, double sigma, double derjaguin_radius,
                           double gap);
double born_spheres_force(double hamaker, double sigma, double derjaguin_radius,
                          double gap);

}  // namespace colloid
