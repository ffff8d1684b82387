#include "particles/injection_sequence.h"

#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "core/text.h"

namespace colloid {

namespace {

// Addresses within a colloid's stream: the gap before it, then one pair per position.
constexpr std::uint64_t kGapIndex = 0;
constexpr std::uint64_t kFirstPosition = 1;

constexpr int kMostDraws = 10000;

}  // namespace

InjectionSequence::InjectionSequence(InjectionPlan plan, std::uint64_t seed)
    : plan_(std::move(plan)), random_(seed) {
  assert(plan_.colloid_radius > 0.0 && plan_.inlet_area > 0.0);
  assert(plan_.volume_fraction >= 0.0);
}

const InjectedColloid& InjectionSequence::at(int index) {
  assert(index >= 0);
  while (colloids_.size() <= static_cast<std::size_t>(index)) {
    colloids_.push_back(next());
  }
  return colloids_[static_cast<std::size_t>(index)];
}

InjectedColloid InjectionSequence::next() const {
  const double a = plan_.colloid_radius;
  const double mean_gap = 4.0 / 3.0 * kPi * a * a * a / plan_.volume_fraction;
  InjectedColloid colloid;
  colloid.index = static_cast<int>(colloids_.size());
  RandomAddress address{RandomPurpose::injection,
                        static_cast<std::uint32_t>(colloid.index), kGapIndex};
  colloid.volume = (colloids_.empty() ? 0.0 : colloids_.back().volume) +
                   mean_gap * random_.exponential(address);
  if (std::isinf(colloid.volume)) {
    return colloid;  // phi = 0: never enters, so it needs no place
  }
  bool grains_only = true;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    address.index = kFirstPosition + static_cast<std::uint64_t>(draw);
    colloid.position = draw_position(address);
    colloid.redraws = draw;
    const Obstacle obstacle = obstacle_at(colloid.position, colloid.volume);
    if (obstacle == Obstacle::none) {
      return colloid;
    }
    grains_only = grains_only && obstacle == Obstacle::grain;
  }
  require(!grains_only, "/geometry",
          fmt::format("leaves a colloid no place at the inlet: grains are in the way of "
                      "{} of {} positions; expected grains further from the inlet or "
                      "smaller colloids",
                      kMostDraws, kMostDraws));
  throw InputError(
      "/colloids/volume_fraction",
      fmt::format("is {}: the inlet is too crowded, colloid {} finds no free place in {} "
                  "draws; expected a smaller volume fraction",
                  shortest(plan_.volume_fraction), colloid.index, kMostDraws));
}

Vec3 InjectionSequence::draw_position(const RandomAddress& at) const {
  const std::array<double, 2> u = random_.uniform_pair(at);
  Vec3 position = plan_.low;
  std::size_t drawn = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != axis_of(plan_.inlet_face)) {
      position[axis] += u[drawn++] * (plan_.high[axis] - plan_.low[axis]);
    }
  }
  return position;
}

InjectionSequence::Obstacle InjectionSequence::obstacle_at(const Vec3& position,
                                                           double volume) const {
  for (const Sphere& grain : plan_.grains) {
    if (distance(position, grain.center) <
        plan_.colloid_radius + grain.radius + plan_.capture_gap) {
      return Obstacle::grain;
    }
  }
  // Earlier colloids in plug flow: the last is the nearest to the inlet.
  const double contact = 2.0 * plan_.colloid_radius + plan_.capture_gap;
  for (auto earlier = colloids_.rbegin(); earlier != colloids_.rend(); ++earlier) {
    const double moved = (volume - earlier->volume) / plan_.inlet_area;
    if (moved >= contact) {
      break;
    }
    Vec3 now = earlier->position;
    now[axis_of(plan_.inlet_face)] += moved;  // as far away to either side
    if (distance(position, now) < contact) {
      return Obstacle::colloid;
    }
  }
  return Obstacle::none;
}

/// Of the nearest periodic images.
double InjectionSequence::distance(const Vec3& a, const Vec3& b) const {
  Vec3 between = a - b;
  for (int axis = 0; axis < 3; ++axis) {
    if (plan_.periodic[static_cast<std::size_t>(axis)]) {
      between[axis] = std::remainder(between[axis], plan_.high[axis] - plan_.low[axis]);
    }
  }
  return norm(between);
}

}  // namespace colloid
