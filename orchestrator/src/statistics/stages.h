// The four stages of clogging, read from the ensemble's mean curves.
//
// The first ends at the median time of first retention, the second where the mean
// critical diameter falls to the colloid's diameter, the third where, after the maximum
// of its standard deviation s, |ds/dt| stays below 5 % of the largest |ds/dt|; the fourth
// is the rest.  The definitions do not put the second and third in order: a spread that
// settles early ends the third first.  ds/dt is the difference quotient on the grid, so
// the end of the third stage is known to one grid step and depends on the grid: recorded
// curves are steps, whose jumps a finer grid makes steeper.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace colloid::statistics {

/// First time at which `curve` falls to `threshold`, linear between grid points; none if
/// it does not.
std::optional<double> first_fall_to(double threshold, const std::vector<double>& time,
                                    const std::vector<double>& curve);

/// First grid time from the maximum of `sd` on after which |d sd/dt| stays below `share`
/// of its largest value; none if sd never changes or has not settled by the end.
std::optional<double> settling_time(const std::vector<double>& time,
                                    const std::vector<double>& sd, double share);

struct Stages {
  std::optional<double> end_of_first;   ///< [s]
  std::optional<double> end_of_second;  ///< [s]
  std::optional<double> end_of_third;   ///< [s]
};

}  // namespace colloid::statistics
