#include "physics/pair_analysis.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace colloid {

namespace {

constexpr int kGridPoints = 800;
// The double layer has decayed to exp(-200) at the end of the grid; what remains is the
// monotonic van der Waals tail.
constexpr double kDebyeLengthsToTheEnd = 200.0;
constexpr int kExtremumBits = 26;  // half of a double's: an extremum is that flat

using Function = std::function<double(double)>;  // of u = ln h

/// A force sampled outwards, u = ln h ascending.
struct Sample {
  double u;
  double force;
};

double root_between(const Function& f, const Sample& a, const Sample& b) {
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      f, a.u, b.u, a.force, b.force, boost::math::tools::eps_tolerance<double>(50),
      iterations);
  return 0.5 * (bracket.first + bracket.second);
}

// Grid points and, between them, the refined local extrema.
std::vector<Sample> sample(const Function& f, double first_gap, double last_gap) {
  const double u_0 = std::log(first_gap);
  const double du = (std::log(last_gap) - u_0) / (kGridPoints - 1);
  std::vector<Sample> grid;
  grid.reserve(kGridPoints);
  for (int i = 0; i < kGridPoints; ++i) {
    grid.push_back({u_0 + i * du, f(u_0 + i * du)});
  }
  std::vector<Sample> samples{grid.front()};
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
    const double left = grid[i].force - grid[i - 1].force;
    const double right = grid[i + 1].force - grid[i].force;
    if (left * right < 0.0) {
      const double sign = left < 0.0 ? 1.0 : -1.0;  // Brent minimises
      const auto extremum = boost::math::tools::brent_find_minima(
          [&](double u) { return sign * f(u); }, grid[i - 1].u, grid[i + 1].u,
          kExtremumBits);
      samples.push_back({extremum.first, sign * extremum.second});
    }
    samples.push_back(grid[i]);
  }
  samples.push_back(grid.back());
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.u < b.u; });
  return samples;
}

double end_of_the_grid(const SurfaceForces& forces) {
  return std::max(1e-6, kDebyeLengthsToTheEnd * forces.debye_length());
}

std::vector<Sample> sample_force(const SurfaceForces& forces) {
  return sample([&](double u) { return forces.force(std::exp(u)); },
                forces.pair().closest_gap, end_of_the_grid(forces));
}

StationaryPoint point_at(const SurfaceForces& forces, StationaryPoint::Kind kind,
                         double gap) {
  const double energy = forces.energy(gap);
  return {kind, gap, energy, energy / forces.thermal_energy()};
}

std::vector<StationaryPoint> find_stationary_points(const SurfaceForces& forces,
                                                    const std::vector<Sample>& samples) {
  const Function f = [&](double u) { return forces.force(std::exp(u)); };
  std::vector<StationaryPoint> points;
  for (std::size_t i = samples.size() - 1; i > 0; --i) {
    const Sample& inner = samples[i - 1];
    const Sample& outer = samples[i];
    if ((inner.force > 0.0) == (outer.force > 0.0) || inner.force == 0.0 ||
        outer.force == 0.0) {
      continue;
    }
    // Repulsive inside and attractive outside: the energy is lowest in between.
    const auto kind = inner.force > 0.0 ? StationaryPoint::Kind::minimum
                                        : StationaryPoint::Kind::maximum;
    points.push_back(point_at(forces, kind, std::exp(root_between(f, inner, outer))));
  }
  if (samples.front().force < 0.0) {
    points.push_back(
        point_at(forces, StationaryPoint::Kind::minimum, forces.pair().closest_gap));
  }
  return points;
}

bool held_up_by_born(const SurfaceForces& forces, const StationaryPoint& minimum) {
  return minimum.gap <= forces.pair().closest_gap ||
         forces.born_force(minimum.gap) >= forces.double_layer_force(minimum.gap);
}

void keep_if_deeper(std::optional<StationaryPoint>& kept, const StationaryPoint& point) {
  if (!kept || point.energy < kept->energy) {
    kept = point;
  }
}

void classify(const SurfaceForces& forces, PairAnalysis& analysis) {
  using Kind = StationaryPoint::Kind;
  for (const StationaryPoint& point : analysis.stationary_points) {
    if (point.kind == Kind::maximum &&
        (!analysis.barrier || point.energy > analysis.barrier->energy)) {
      analysis.barrier = point;
    }
  }
  for (const StationaryPoint& point : analysis.stationary_points) {
    if (point.kind == Kind::maximum) {
      continue;
    }
    const bool inside = analysis.barrier ? point.gap < analysis.barrier->gap
                                         : held_up_by_born(forces, point);
    keep_if_deeper(inside ? analysis.primary_minimum : analysis.secondary_minimum, point);
  }
}

void measure_barrier(const SurfaceForces& forces, PairAnalysis& analysis) {
  double top = 0.0;
  if (analysis.barrier) {
    top = analysis.barrier->energy_kT;
  } else if (!analysis.primary_minimum) {
    top = forces.energy(forces.pair().closest_gap) / forces.thermal_energy();
  } else {
    return;  // downhill all the way
  }
  const double start =
      analysis.secondary_minimum ? analysis.secondary_minimum->energy_kT : 0.0;
  analysis.barrier_from_outside_kT = std::max(0.0, top);
  analysis.barrier_from_secondary_kT = std::max(0.0, top - std::min(0.0, start));
}

/// Largest sign * force from `from` to `to` [m]; zero force if there is none of that
/// sign.
ForceAtGap largest(const std::vector<Sample>& samples, double sign, double from,
                   double to) {
  ForceAtGap found;
  for (const Sample& s : samples) {
    const double gap = std::exp(s.u);
    if (gap >= from && gap <= to && sign * s.force > found.force) {
      found = {sign * s.force, gap};
    }
  }
  return found;
}

/// Largest gap at which `magnitude` is at least `force`, looked for inwards from
/// `last_gap`.
double outermost(const Function& magnitude, double first_gap, double last_gap,
                 double force) {
  const Function excess = [&](double u) { return magnitude(std::exp(u)) - force; };
  const std::vector<Sample> samples = sample(excess, first_gap, last_gap);
  if (samples.back().force >= 0.0) {
    return last_gap;
  }
  for (std::size_t i = samples.size() - 1; i > 0; --i) {
    if (samples[i - 1].force >= 0.0) {
      return std::exp(root_between(excess, samples[i - 1], samples[i]));
    }
  }
  return 0.0;
}

/// No force of magnitude `force` acts beyond this gap: twice the unretarded van der Waals
/// gap, and the end of the double layer.
double beyond_every_force(const SurfaceForces& forces, double force) {
  const double van_der_waals =
      std::sqrt(std::abs(forces.pair().hamaker) * forces.derjaguin_radius() / force);
  return std::max(end_of_the_grid(forces), van_der_waals);
}

}  // namespace

PairAnalysis analyse_pair(const SurfaceForces& forces) {
  const std::vector<Sample> samples = sample_force(forces);
  const double closest = forces.pair().closest_gap;
  const double end = 2.0 * end_of_the_grid(forces);

  PairAnalysis analysis;
  analysis.stationary_points = find_stationary_points(forces, samples);
  classify(forces, analysis);
  measure_barrier(forces, analysis);

  const double top = analysis.barrier ? analysis.barrier->gap : closest;
  if (analysis.barrier || !analysis.primary_minimum) {
    analysis.largest_repulsion = largest(samples, 1.0, top, end);
  }
  if (analysis.primary_minimum) {
    analysis.primary_pull_off = largest(samples, -1.0, analysis.primary_minimum->gap,
                                        analysis.barrier ? analysis.barrier->gap : end);
  }
  if (analysis.secondary_minimum) {
    analysis.secondary_pull_off =
        largest(samples, -1.0, analysis.secondary_minimum->gap, end);
  }
  return analysis;
}

double capture_gap(const SurfaceForces& forces, double force) {
  assert(force > 0.0);
  return outermost([&](double gap) { return -forces.force(gap); },
                   forces.pair().closest_gap, beyond_every_force(forces, force), force);
}

double van_der_waals_capture_gap(const SurfaceForces& forces, double force) {
  assert(force > 0.0);
  return outermost([&](double gap) { return -forces.van_der_waals_force(gap); },
                   forces.pair().closest_gap, beyond_every_force(forces, force), force);
}

double interaction_range(const SurfaceForces& forces, double force) {
  assert(force > 0.0);
  return outermost([&](double gap) { return std::abs(forces.force(gap)); },
                   forces.pair().closest_gap, beyond_every_force(forces, force), force);
}

}  // namespace colloid
