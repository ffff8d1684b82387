// The liquid between two surfaces, as far as surface forces see it.
#pragma once

namespace colloid {

/// A symmetric 1:1 electrolyte; defaults are the reference scene's.
struct Electrolyte {
  double ionic_strength = 300.0;         ///< I [mol/m^3]; 1 mM = 1 mol/m^3
  double relative_permittivity = 78.55;  ///< eps_r [-]
  double temperature = 298.0;            ///< T [K]
};

/// k_B T [J].
double thermal_energy(double temperature);

/// eps = eps_r eps_0 [F/m].
double permittivity(const Electrolyte& electrolyte);

/// Decay length of the double layer [m], MODEL (S1):
///
///     1/kappa = sqrt(eps k_B T / (2 N_A e^2 I)),     I in mol/m^3
///
/// Source: Debye & Hueckel (1923); Russel, Saville & Schowalter (1989), section 4.3.
double debye_length(const Electrolyte& electrolyte);

}  // namespace colloid
