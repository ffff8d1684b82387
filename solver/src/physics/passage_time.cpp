#include "physics/passage_time.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

namespace colloid {

namespace {

constexpr int kFirstCells = 200;  // uniform in ln h
// Of W/kT over one cell, and of its middle from the mean of its ends: of exp(W) Simpson's
// rule then errs by 1e-7 on a slope and by 4e-7 on a top.
constexpr double kLargestStep = 0.125;
constexpr double kLargestBend = 0.0025;
constexpr int kMostHalvings = 30;

using Gauss = boost::math::quadrature::gauss<double, 7>;

double log_of_sum(double a, double b) {
  const double larger = std::max(a, b);
  return std::isinf(larger) ? larger : larger + std::log1p(std::exp(-std::abs(a - b)));
}

/// A gap and the energy there.
struct Point {
  double h;
  double w;
};

/// Appends the ends of the cells that `from` to `to` is cut into, `from` excluded.
void cut(const std::function<double(double)>& energy, const Point& from, const Point& to,
         int halvings, std::vector<Point>& ends) {
  const double h = 0.5 * (from.h + to.h);
  const Point middle{h, energy(h)};
  const double step = std::max(std::abs(middle.w - from.w), std::abs(to.w - middle.w));
  const double bend = std::abs(middle.w - 0.5 * (from.w + to.w));
  if ((2.0 * step <= kLargestStep && bend <= kLargestBend) || halvings == 0) {
    ends.push_back(to);
    return;
  }
  cut(energy, from, middle, halvings - 1, ends);
  cut(energy, middle, to, halvings - 1, ends);
}

std::vector<Point> cells(const std::function<double(double)>& energy, double from,
                         double to) {
  std::vector<Point> ends{{from, energy(from)}};
  for (int i = 1; i <= kFirstCells && to > from; ++i) {
    const double h =
        i == kFirstCells ? to : from * std::pow(to / from, double(i) / kFirstCells);
    const Point before = ends.back();
    cut(energy, before, {h, energy(h)}, kMostHalvings, ends);
  }
  return ends;
}

/// ln J, J(h) = exp(W(h)) int_h^reflecting exp(-W) dh', carried inwards over one
/// interval.
double inwards(const std::function<double(double)>& energy, double log_j,
               const Point& inner, const Point& outer) {
  const double inside = Gauss::integrate(
      [&](double h) { return std::exp(inner.w - energy(h)); }, inner.h, outer.h);
  return log_of_sum(log_j + inner.w - outer.w, std::log(inside));
}

}  // namespace

double mean_passage_time(const Passage& passage) {
  assert(passage.absorbing > 0.0 && passage.absorbing < passage.start);
  assert(passage.start <= passage.reflecting);
  constexpr double kNothing = -std::numeric_limits<double>::infinity();

  const std::vector<Point> outside =
      cells(passage.energy_kT, passage.start, passage.reflecting);
  double log_j = kNothing;
  for (std::size_t i = outside.size(); i-- > 1;) {
    log_j = inwards(passage.energy_kT, log_j, outside[i - 1], outside[i]);
  }

  const auto rate = [&](double log_of_j, double h) {
    return log_of_j - std::log(passage.diffusivity(h));
  };
  const std::vector<Point> inside =
      cells(passage.energy_kT, passage.absorbing, passage.start);
  double log_time = kNothing;
  double log_outer = rate(log_j, passage.start);
  for (std::size_t i = inside.size(); i-- > 1;) {
    const Point& inner = inside[i - 1];
    const Point& outer = inside[i];
    const double h = 0.5 * (inner.h + outer.h);
    const Point middle{h, passage.energy_kT(h)};
    log_j = inwards(passage.energy_kT, log_j, middle, outer);
    const double log_middle = rate(log_j, h) + std::log(4.0);
    log_j = inwards(passage.energy_kT, log_j, inner, middle);
    const double log_inner = rate(log_j, inner.h);
    // Simpson's rule
    const double sum = log_of_sum(log_of_sum(log_inner, log_middle), log_outer);
    log_time = log_of_sum(log_time, sum + std::log((outer.h - inner.h) / 6.0));
    log_outer = log_inner;
  }
  return log_time > std::log(1e300) ? std::numeric_limits<double>::infinity()
                                    : std::exp(log_time);
}

}  // namespace colloid
