#include "statistics/annuli.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace colloid::statistics {

namespace {

constexpr double kRoundOff = 1e-9;  // of a length, in units of the annuli's width
constexpr double kMost = 1e6;

}  // namespace

Annuli::Annuli(const Section& section, double width)
    : half_x_(0.5 * (section.x.high - section.x.low)),
      half_y_(0.5 * (section.y.high - section.y.low)),
      centre_x_(0.5 * (section.x.high + section.x.low)),
      centre_y_(0.5 * (section.y.high + section.y.low)) {
  require_finite({half_x_, half_y_, centre_x_, centre_y_, width}, "inlet section");
  if (!(half_x_ > 0.0 && half_y_ > 0.0 && width > 0.0)) {
    throw InvalidSample("inlet section: its sides and the annuli's width must exceed 0");
  }
  const double reach = std::max(half_x_, half_y_);
  // A section of a whole number of widths has no sliver of an annulus at its edge.
  const double count = std::max(1.0, std::ceil(reach / width - kRoundOff));
  if (count > kMost) {
    throw InvalidSample("inlet section: " + std::to_string(count) +
                        " annuli, at most a million; is the width in metres?");
  }
  const std::size_t whole = static_cast<std::size_t>(count);
  edges_.reserve(whole + 1);
  for (std::size_t i = 0; i < whole; ++i) {
    edges_.push_back(static_cast<double>(i) * width);
  }
  edges_.push_back(reach);
}

double Annuli::area(std::size_t i) const {
  const auto inside = [this](double d) {
    return 4.0 * std::min(d, half_x_) * std::min(d, half_y_);
  };
  return inside(outer(i)) - inside(inner(i));
}

std::size_t Annuli::at(const std::array<double, 2>& place) const {
  require_finite({place[0], place[1]}, "injection position");
  const double dx = std::abs(place[0] - centre_x_);
  const double dy = std::abs(place[1] - centre_y_);
  const double slack = kRoundOff * edges_[1];
  if (dx > half_x_ + slack || dy > half_y_ + slack) {
    throw InvalidSample("injection position: (" + std::to_string(place[0]) + ", " +
                        std::to_string(place[1]) + ") m lies outside the inlet section");
  }
  const auto above = std::upper_bound(edges_.begin(), edges_.end(), std::max(dx, dy));
  const std::size_t index = static_cast<std::size_t>(above - edges_.begin()) - 1;
  return std::min(index, size() - 1);
}

}  // namespace colloid::statistics
