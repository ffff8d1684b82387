#include "flow/axis_stencil.h"

#include <cassert>

namespace colloid {

namespace {

using Kind = FlowFace::Kind;

Side side_of_tangential(Kind kind) {
  switch (kind) {
    case Kind::velocity:
      return Side::given_velocity;
    case Kind::periodic:
      return Side::neighbour;
    default:
      return Side::no_shear;
  }
}

SecondDifference with_prefactor(SecondDifference d, double width) {
  const bool free = d.side_below == Side::no_shear || d.side_above == Side::no_shear;
  d.prefactor = free ? 1.0 / width : 2.0 / (d.below + d.above);
  return d;
}

float weight(const SecondDifference& d, double distance, Side side) {
  return side == Side::no_shear ? 0.0F : static_cast<float>(d.prefactor / distance);
}

}  // namespace

AxisStencil make_axis_stencil(const Grid& grid, int axis, Kind lower, Kind upper) {
  const auto& w = grid.width[static_cast<std::size_t>(axis)];
  const std::size_t n = w.size();
  assert(n > 0);
  const bool periodic = lower == Kind::periodic;
  AxisStencil s;
  s.at_face.resize(n + 1);
  s.at_centre.resize(n);
  const auto length =
      static_cast<std::size_t>(whole_blocks(static_cast<int>(n) + 3 + kBlock));
  s.face_below.assign(length, 0.0F);
  s.face_above.assign(length, 0.0F);
  s.centre_below.assign(length, 0.0F);
  s.centre_above.assign(length, 0.0F);
  s.gradient.assign(length, 0.0F);
  s.divergence.assign(length, 0.0F);

  for (std::size_t i = 0; i <= n; ++i) {
    const bool first = i == 0 && !periodic;
    const bool last = i == n && !periodic;
    SecondDifference d;
    d.below = first ? w[0] : w[(i + n - 1) % n];
    d.above = last ? w[n - 1] : w[i % n];
    // On the box's own face only a pressure face has an unknown; beyond it nothing pulls.
    d.side_below = first ? Side::no_shear : Side::neighbour;
    d.side_above = last ? Side::no_shear : Side::neighbour;
    d = with_prefactor(d, 0.5 * (first ? d.above : d.below));
    s.at_face[i] = d;
    s.face_below[i + 1] = weight(d, d.below, d.side_below);
    s.face_above[i + 1] = weight(d, d.above, d.side_above);
    s.gradient[i + 1] =
        static_cast<float>(2.0 / (first || last ? d.below : d.below + d.above));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0 && !periodic;
    const bool last = i == n - 1 && !periodic;
    SecondDifference d;
    d.below = 0.5 * (w[i] + (first ? 0.0 : w[(i + n - 1) % n]));
    d.above = 0.5 * (w[i] + (last ? 0.0 : w[(i + 1) % n]));
    d.side_below = first ? side_of_tangential(lower) : Side::neighbour;
    d.side_above = last ? side_of_tangential(upper) : Side::neighbour;
    d = with_prefactor(d, w[i]);
    s.at_centre[i] = d;
    s.centre_below[i + 1] = weight(d, d.below, d.side_below);
    s.centre_above[i + 1] = weight(d, d.above, d.side_above);
    s.divergence[i + 1] = static_cast<float>(1.0 / w[i]);
  }
  return s;
}

}  // namespace colloid
