#include "flow/wall_moment.h"

#include <algorithm>
#include <cmath>

namespace colloid {

namespace {

// Below this slope, relative to the larger one, the rectangle is treated as a strip: the
// quotient below would lose its digits, and M changes by less than its square.
constexpr double kFlat = 1e-4;

double cube_over_six(double x) {
  return x > 0.0 ? x * x * x / 6.0 : 0.0;
}
double square_over_two(double x) {
  return x > 0.0 ? 0.5 * x * x : 0.0;
}

}  // namespace

double wall_moment(double d, double g1, double g2) {
  const double big = std::max(std::abs(g1), std::abs(g2));
  const double small = std::min(std::abs(g1), std::abs(g2));
  const double reach = 0.5 * (big + small);
  if (d >= reach) {
    return d;
  }
  if (d <= -reach) {
    return 0.0;
  }
  if (small <= kFlat * big) {
    return (square_over_two(d + 0.5 * big) - square_over_two(d - 0.5 * big)) / big;
  }
  const double sum =
      cube_over_six(d + 0.5 * (big + small)) - cube_over_six(d + 0.5 * (big - small)) -
      cube_over_six(d - 0.5 * (big - small)) + cube_over_six(d - 0.5 * (big + small));
  return std::max(0.0, sum / (big * small));
}

}  // namespace colloid
