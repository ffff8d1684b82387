#include "tiers/transient/dem_lubrication.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.h"
#include "core/error.h"

namespace colloid {

namespace {

constexpr double kTolerance = 1e-10;  // of the largest force
constexpr int kSweeps = 20000;

// (T9), measured by tests/verification/transient_lubrication.
struct Point {
  double gap, resistance;
};
constexpr std::array<Point, 13> kResolved{{{0.0, 1.32},
                                           {0.1, 1.29},
                                           {0.2, 1.245},
                                           {0.3, 1.20},
                                           {0.4, 1.14},
                                           {0.5, 1.08},
                                           {0.6, 1.005},
                                           {0.8, 0.89},
                                           {1.0, 0.80},
                                           {1.25, 0.67},
                                           {1.5, 0.578},
                                           {2.0, 0.463},
                                           {3.0, 1.0 / 3.0}}};

}  // namespace

double resolved_resistance(double x) {
  if (x >= kResolvedGap) {
    return 1.0 / x;
  }
  const auto* above = std::find_if(kResolved.begin(), kResolved.end() - 1,
                                   [&](const Point& p) { return p.gap > x; });
  const auto* below = above - 1;
  const double part = (x - below->gap) / (above->gap - below->gap);
  return std::min(1.0 / x,
                  below->resistance + part * (above->resistance - below->resistance));
}

double lubrication_resistance(double viscosity, double reduced_radius, double gap,
                              double cell, double floor) {
  const double h = std::max(gap, floor);
  return 6.0 * kPi * viscosity * reduced_radius * reduced_radius *
         std::max(0.0, 1.0 / h - resolved_resistance(h / cell) / cell);
}

void solve_lubrication(std::vector<NarrowGap>& gaps, const std::vector<double>& inertia,
                       std::vector<Vec3>& velocity) {
  const auto slot = [](int index) { return static_cast<std::size_t>(index); };
  for (NarrowGap& gap : gaps) {
    gap.force = 0.0;
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double largest = 0.0;
    double change = 0.0;
    for (NarrowGap& gap : gaps) {
      double opening = 0.0;
      double compliance = 0.0;
      if (gap.first >= 0) {
        opening += dot(gap.normal, velocity[slot(gap.first)]);
        compliance += 1.0 / inertia[slot(gap.first)];
      }
      if (gap.second >= 0) {
        opening -= dot(gap.normal, velocity[slot(gap.second)]);
        compliance += 1.0 / inertia[slot(gap.second)];
      }
      const double more =
          -(gap.force + gap.resistance * opening) / (1.0 + gap.resistance * compliance);
      gap.force += more;
      if (gap.first >= 0) {
        velocity[slot(gap.first)] += more / inertia[slot(gap.first)] * gap.normal;
      }
      if (gap.second >= 0) {
        velocity[slot(gap.second)] -= more / inertia[slot(gap.second)] * gap.normal;
      }
      largest = std::max(largest, std::abs(gap.force));
      change = std::max(change, std::abs(more));
    }
    if (gaps.size() == 1 || change <= kTolerance * largest) {
      return;
    }
  }
  throw ConvergenceError("DEM: the lubrication forces between colloids do not converge");
}

}  // namespace colloid
