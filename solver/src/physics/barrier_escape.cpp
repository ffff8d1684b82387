#include "physics/barrier_escape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <boost/math/tools/minima.hpp>

#include "core/constants.h"
#include "core/error.h"
#include "physics/pair_resistance.h"
#include "physics/passage_time.h"
#include "physics/wall_resistance.h"

namespace colloid {

namespace {

constexpr int kGridPoints = 1000;
constexpr int kExtremumBits = 26;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A colloid this far downhill does not come back, and one does not get this far uphill:
// exp(-60) = 1e-26 [kT].
constexpr double kOutOfReach = 60.0;
constexpr double kNever = 720.0;  // [kT] beyond a double whatever the diffusivity

using Function = std::function<double(double)>;

/// A point of the curve W(h)/kT.
struct Point {
  double gap;
  double energy;
};

/// The well outside the barrier and what bounds it.
struct Well {
  Point bottom;
  Point top;         ///< highest point between the primary minimum and the bottom
  double outer_gap;  ///< of the curve's next maximum outside, or the last gap
};

Point extremum_between(const Function& energy, double from, double to, double sign) {
  const auto found = boost::math::tools::brent_find_minima(
      [&](double u) { return sign * energy(std::exp(u)); }, std::log(from), std::log(to),
      kExtremumBits);
  return {std::exp(found.first), sign * found.second};
}

/// The deepest minimum outside the first point of the curve, on a grid uniform in ln h.
std::optional<Well> find_well(const Function& energy, double from, double to) {
  std::vector<Point> grid;
  grid.reserve(kGridPoints);
  for (int i = 0; i < kGridPoints; ++i) {
    const double gap = from * std::pow(to / from, double(i) / (kGridPoints - 1));
    grid.push_back({gap, energy(gap)});
  }
  std::optional<Well> well;
  Point top = grid.front();
  bool closed = true;  // no maximum is looked for outside the well found last
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
    const bool lower = grid[i].energy < grid[i - 1].energy;
    const bool rises = grid[i + 1].energy >= grid[i].energy;
    if (lower == rises && lower) {
      const Point bottom =
          extremum_between(energy, grid[i - 1].gap, grid[i + 1].gap, 1.0);
      if (!well || bottom.energy < well->bottom.energy) {
        well = Well{bottom, top, to};
        closed = false;
      }
    } else if (lower == rises) {
      const Point maximum =
          extremum_between(energy, grid[i - 1].gap, grid[i + 1].gap, -1.0);
      if (!closed) {
        well->outer_gap = maximum.gap;
        closed = true;
      }
      top = maximum.energy > top.energy ? maximum : top;
    }
  }
  return well;
}

/// From `from` towards `to`, the first gap at which the curve is `difference` away from
/// the energy `from_energy` (above it if positive, below if negative); `to` if there is
/// none.
double reach(const Function& energy, Point from, double to, double difference) {
  constexpr int kSteps = 1000;
  constexpr int kHalvings = 20;
  const auto reached = [&](double gap) {
    const double rise = energy(gap) - from.energy;
    return difference > 0.0 ? rise > difference : rise < difference;
  };
  double before = from.gap;
  for (int i = 1; i < kSteps; ++i) {
    double gap = from.gap * std::pow(to / from.gap, double(i) / kSteps);
    if (reached(gap)) {
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (before + gap);
        (reached(middle) ? gap : before) = middle;
      }
      return gap;
    }
    before = gap;
  }
  return to;
}

/// Force over 6 pi mu a U of the colloid's normal motion, against its gap [m].
Function normal_resistance(const SurfacePair& pair) {
  constexpr double kLargestRatio = 20.0;  // beyond, the other sphere is a plane
  if (pair.shape == PairShape::sphere_plate ||
      pair.other_radius > kLargestRatio * pair.radius) {
    return [a = pair.radius](double gap) { return wall_resistance(gap / a).f_n; };
  }
  const double mean = 0.5 * (pair.radius + pair.other_radius);
  const auto two = std::make_shared<TwoSphereResistance>(pair.other_radius / pair.radius);
  return [mean, two](double gap) { return two->at(gap / mean).xa11; };
}

}  // namespace

BarrierEscape barrier_escape(const SurfaceForces& forces, const PairAnalysis& analysis,
                             const EscapeConditions& conditions) {
  require(std::isfinite(conditions.viscosity) && conditions.viscosity > 0.0, "/escape",
          "the viscosity must be positive");
  require(std::isfinite(conditions.force_towards), "/escape",
          "the force is not a number");
  if (!analysis.primary_minimum) {
    return {kInfinity, kInfinity, 0.0};
  }
  const double radius = forces.pair().radius;
  const double thermal = forces.thermal_energy();
  const Function energy = [&](double gap) {
    return (forces.energy(gap) + conditions.force_towards * gap) / thermal;
  };
  const double primary = analysis.primary_minimum->gap;
  const double last = std::max(radius, 2.0 * primary);

  Point top{};
  Passage passage;
  if (const std::optional<Well> well = find_well(energy, primary, last)) {
    top = well->top;
    passage.start = well->bottom.gap;
    passage.reflecting = reach(energy, well->bottom, well->outer_gap, kOutOfReach);
  } else {
    const double inside = analysis.barrier ? analysis.barrier->gap : primary;
    passage.start = inside + forces.debye_length();
    passage.reflecting = passage.start;
    top = {passage.start, energy(passage.start)};
    if (forces.force(passage.start) >= conditions.force_towards) {
      return {kInfinity, kInfinity, passage.start};
    }
  }
  const double barrier = top.energy - energy(passage.start);
  if (barrier > kNever) {
    return {kInfinity, barrier, passage.start};
  }
  passage.absorbing = reach(energy, top, primary, -kOutOfReach);
  passage.energy_kT = energy;
  const double bulk = thermal / (6.0 * kPi * conditions.viscosity * radius);
  passage.diffusivity = [bulk, f = normal_resistance(forces.pair())](double gap) {
    return bulk / f(gap);
  };
  return {mean_passage_time(passage), barrier, passage.start};
}

}  // namespace colloid
