// Mean time a diffusing particle takes to reach an absorbing point from a start, with a
// reflecting point on the other side.
#pragma once

#include <functional>

namespace colloid {

/// One-dimensional diffusion on h in [absorbing, reflecting].
struct Passage {
  std::function<double(double)> energy_kT;    ///< W(h) / (k_B T) [-], h in m
  std::function<double(double)> diffusivity;  ///< D(h) [m^2/s]
  double absorbing = 0.0;                     ///< [m], below start, above 0
  double start = 0.0;                         ///< [m]
  double reflecting = 0.0;                    ///< [m], at start or beyond
};

/// [s]; MODEL (S15):
///
///     tau = int_absorbing^start exp(W/kT)/D dh  int_h^reflecting exp(-W/kT) dh'
///
/// Pontryagin, Andronov & Vitt (1933); Gardiner, Handbook of Stochastic Methods, 5.2.7.
/// Computed by its logarithm: a time beyond 1e300 s is returned as infinity.
double mean_passage_time(const Passage& passage);

}  // namespace colloid
