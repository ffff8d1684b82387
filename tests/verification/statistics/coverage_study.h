// Simulated coverage: draw samples whose truth is known, count the intervals that hold
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "draws.h"

namespace colloid::statistics {

/// Share of `samples` intervals that held the truth.
struct Coverage {
  double rate = 0.0;
  std::size_t samples = 0;

  /// Of `rate`, from the binomial at 0.95.
  double standard_error() const;
};

struct SurvivalCoverage {
  Coverage survival;  ///< S(1), pointwise
  Coverage median;
  Coverage restricted_mean;  ///< mu(2)
};

struct ExponentialCoverage {
  Coverage amplitude;
  Coverage rate;
  std::size_t without_interval = 0;  ///< too many resamples had no minimum
};

struct BootstrapCoverage {
  Coverage percentile;
  Coverage bca;
};

struct BandCoverage {
  Coverage pointwise;      ///< at the last grid point
  Coverage simultaneous;   ///< at all grid points
  Coverage all_pointwise;  ///< the pointwise intervals taken for a band
};

Coverage student_of_normal(std::size_t n, std::size_t samples);
Coverage student_of_exponential(std::size_t n, std::size_t samples);
SurvivalCoverage survival(std::size_t n, std::size_t samples);
BootstrapCoverage bootstrap_of_exponential(std::size_t n, std::size_t samples);
BandCoverage band(std::size_t n, std::size_t samples);
ExponentialCoverage exponential_profile(std::size_t n, std::size_t samples);
Coverage censored_slope(std::size_t n, std::size_t samples);

}  // namespace colloid::statistics
