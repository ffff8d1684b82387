// Survival from censored realisations: the product-limit estimate and its median.
//
// A realisation that has not clogged when it ended is right-censored: it was at risk
// until then, and nothing more is known.  At t_1 < t_2 < ... with d_i events of n_i at
// risk
//
//     S(t) = prod_{t_i <= t} (1 - d_i / n_i),   G(t) = sum_{t_i <= t} d_i / [n_i (n_i -
//     d_i)]
//
// (Kaplan & Meier 1958, JASA 53, 457; G by Greenwood 1926); an event comes before a
// censoring at the same time.  The interval is the log-log one,
// [S^(1/theta), S^theta], theta = exp(-z sqrt G / |ln S|) (Kalbfleisch & Prentice 1980).
// Where S = 1 it has no width, so there the exact bound of 0 events in n_i stands; where
// S = 0 that of n events in n if nothing was censored before, else the upper limit of the
// step before, which S cannot exceed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "statistics/interval.h"

namespace colloid::statistics {

/// One realisation's time to an event [s], or the time until which it had none.
struct Observation {
  double time = 0.0;
  bool event = false;
};

struct SurvivalStep {
  double time = 0.0;
  std::size_t at_risk = 0;  ///< just before `time`
  std::size_t events = 0;
  std::size_t censored = 0;
  double survival = 1.0;   ///< from `time` to the next step's
  double greenwood = 0.0;  ///< G; infinite where survival is 0
  Interval interval;       ///< pointwise
};

struct KaplanMeier {
  std::size_t n = 0;
  std::size_t n_events = 0;
  double level = 0.0;
  std::vector<SurvivalStep>
      steps;  ///< from time 0, one per distinct time; empty if n = 0
  std::string method;
};

/// Times must be finite and not negative.
KaplanMeier kaplan_meier(std::vector<Observation> observations, double level);

/// The step in force at `time`; none before the first or when n = 0.
const SurvivalStep* step_at(const KaplanMeier& curve, double time);
const SurvivalStep* step_at(KaplanMeier&& curve, double time) = delete;  // would dangle

/// Median time, and the interval of Brookmeyer & Crowley (1982, Biometrics 38, 29): all
/// times at which the pointwise interval of S contains 1/2.  A limit that the curve does
/// not reach is none: the interval is open there.
struct MedianTime {
  std::size_t n = 0;
  double level = 0.0;
  std::optional<double> estimate;  ///< first t with S <= 1/2; none: not reached
  std::optional<double> low;
  std::optional<double> high;
  std::string method;
};

MedianTime median_time(const KaplanMeier& curve);

}  // namespace colloid::statistics
