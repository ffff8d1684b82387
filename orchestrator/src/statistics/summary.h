// All statistics of one design point and tier.
//
// Everything but the survival curve is of the complete prefix in seed order (prefix.h);
// the survival curve is too, unless running realisations are asked to count as censored.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/alpha_fit.h"
#include "statistics/annuli.h"
#include "statistics/bootstrap.h"
#include "statistics/event_probability.h"
#include "statistics/injection_profile.h"
#include "statistics/kaplan_meier.h"
#include "statistics/mean_curve.h"
#include "statistics/mean_interval.h"
#include "statistics/outcome.h"
#include "statistics/restricted_mean.h"
#include "statistics/stages.h"

namespace colloid::statistics {

struct SummaryOptions {
  BootstrapOptions bootstrap;  ///< resamples, confidence, the campaign's seed
  std::optional<double>
      duration;  ///< tau [s]; none: the longest time reached, with a note
  std::optional<double> colloid_diameter;  ///< [m], for the second stage
  std::optional<Section> inlet;            ///< none: no injection profiles
  double annulus_width = 3e-6;             ///< [m]
  double inlet_margin = 0.0;  ///< distance to the edge that colloids' centres keep [m]
  std::size_t grid_points = 201;
  bool hold_last = false;  ///< runs stop when clogged: their curves keep the last value
};

/// A mean with two intervals: Student's and the bootstrap's.
struct MeanTime {
  MeanInterval student;
  BootstrapIntervals bootstrap;
};

struct Clogging {
  KaplanMeier kaplan_meier;
  MedianTime median;
  std::optional<RestrictedMean> restricted_mean;       ///< none: no duration known
  std::optional<EventProbability> probability_by_end;  ///< by the duration
};

struct EnsembleCurves {
  std::vector<double> time;  ///< the common grid [s]
  MeanCurve critical_diameter;
  MeanCurve permeability_ratio;
};

struct PointStatistics {
  std::size_t n = 0;           ///< finished realisations of the prefix
  std::size_t n_censored = 0;  ///< of them, not clogged at their end
  std::size_t n_failed = 0;    ///< of all
  std::size_t n_running = 0;
  std::size_t n_pending = 0;
  std::size_t n_beyond_prefix = 0;  ///< finished, but after one that has not
  double level = 0.0;
  MeanTime t1;  ///< no mean if a realisation retained nothing
  MeanTime tc;  ///< no mean if a realisation is censored: see the restricted mean
  MeanTime tc_minus_t1;
  MedianTime median_t1;
  Clogging clogging;
  EnsembleCurves curves;
  Stages stages;
  AlphaFit alpha_fit;
  std::vector<InjectionProfile> injection;  ///< orders 1 to 5
  std::vector<std::string> warnings;        ///< to be shown with the numbers
};

PointStatistics summarise(const std::vector<RealisationOutcome>& outcomes,
                          const SummaryOptions& options);

}  // namespace colloid::statistics
