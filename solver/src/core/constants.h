// Physical constants, SI.
#pragma once

namespace colloid {

constexpr double kPi = 3.14159265358979323846;
constexpr double kBoltzmann = 1.380649e-23;               ///< [J/K] exact, SI 2019
constexpr double kElementaryCharge = 1.602176634e-19;     ///< [C] exact, SI 2019
constexpr double kAvogadro = 6.02214076e23;               ///< [1/mol] exact, SI 2019
constexpr double kVacuumPermittivity = 8.8541878128e-12;  ///< [F/m] CODATA 2018

}  // namespace colloid
