// Mean of whole curves over realisations, with two kinds of interval.
//
// On a common grid t_j: mean m_j, standard deviation s_j, se_j = s_j / sqrt n.
//   pointwise     m_j +- t_{n-1} se_j: covers the mean at each t_j by itself.
//   simultaneous  m_j +- c se_j for all j at once; c from the bootstrap over whole
//   curves,
//                 c_B = the level-quantile of max_j |m*_j - m_j| / se_j.
// A resampled mean varies (n - 1)/n as much as a mean, and se_j is itself estimated; so
// c = T^-1{Phi[c_B sqrt(n / (n - 1))]} with T of Student's t_{n-1}, which for one point
// is the pointwise interval.
// Source: Degras 2011, Statistica Sinica 21, 1735, for the band by the bootstrap; the
// correction for small n is ours, its coverage is measured in
// tests/verification/statistics.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/bootstrap.h"
#include "statistics/interval.h"

namespace colloid::statistics {

/// A quantity that keeps its value until the next time: what a run recorded.
struct StepSeries {
  std::vector<double> time;  ///< ascending [s]
  std::vector<double> value;
};

/// The series at the times of `grid`: the last value recorded until then.  The grid lies
/// within the series' first time and, unless `hold_last`, its last.
std::vector<double> on_grid(const StepSeries& series, const std::vector<double>& grid,
                            bool hold_last);

/// `points` >= 2 equal steps from 0 to `end`.
std::vector<double> uniform_grid(double end, std::size_t points);

struct MeanCurve {
  std::size_t n = 0;
  double level = 0.0;
  std::size_t resamples = 0;
  std::vector<double> mean;
  std::vector<double> sd;                     ///< empty if n < 2
  std::vector<Interval> interval;             ///< pointwise; empty if n < 2
  std::vector<Interval> band;                 ///< simultaneous; empty if n < 2
  std::optional<double> pointwise_factor;     ///< t_{n-1}
  std::optional<double> simultaneous_factor;  ///< c
  std::string interval_method;
  std::string band_method;
  std::string note;
};

/// `curves` is [realisation][grid point].
MeanCurve mean_curve(const std::vector<std::vector<double>>& curves,
                     const BootstrapOptions& options);

}  // namespace colloid::statistics
