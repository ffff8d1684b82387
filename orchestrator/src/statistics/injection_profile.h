// Where the k-th retained colloids came in: probability per annulus, and exponentials.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "statistics/annuli.h"
#include "statistics/bootstrap.h"
#include "statistics/exponential_fit.h"
#include "statistics/proportion.h"

namespace colloid::statistics {

struct InjectionProfile {
  std::size_t order = 0;       ///< 1: the first colloid retained
  std::size_t n = 0;           ///< realisations
  std::size_t n_without = 0;   ///< of them, those that retained fewer than `order`
  std::vector<double> centre;  ///< of each annulus, from the section's centre [m]
  std::vector<Proportion> probability;  ///< fraction of the n realisations per annulus
  std::vector<double> density;          ///< probability per area of the annulus [1/m^2]
  /// Through the annuli whose centre a colloid's centre can reach.
  ExponentialFit probability_fit;
  ExponentialFit density_fit;
};

/// `positions` holds one list per realisation, in the order of retention; `margin` [m] is
/// how close to the section's edge a colloid's centre can be injected.
InjectionProfile injection_profile(
    std::size_t order, const std::vector<std::vector<std::array<double, 2>>>& positions,
    const Annuli& annuli, double margin, const BootstrapOptions& options);

}  // namespace colloid::statistics
