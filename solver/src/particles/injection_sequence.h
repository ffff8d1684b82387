// Which colloids enter, after how much liquid, and where: the same for every tier, drive
// and option.                                                           MODEL section I
//
// A Poisson process in the injected VOLUME of suspension, with one colloid per V_p/phi on
// average; with the flow rate Q(t) of a run it becomes a process in time.  Positions are
// uniform over the part of the inlet where a colloid has room.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/box.h"
#include "core/random.h"

namespace colloid {

/// Where and how densely colloids enter.
struct InjectionPlan {
  /// Unit vector against the flow: out of the inlet.
  Vec3 upstream() const {
    Vec3 up;
    up[axis_of(inlet_face)] = is_upper(inlet_face) ? 1.0 : -1.0;
    return up;
  }

  int inlet_face = z_plus;  ///< a Face: its axis and side
  /// Corners of the rectangle of admissible centres [m].  On the inlet's axis both have
  /// the coordinate at which a colloid's top is in the inlet plane; on a periodic axis
  /// they span the whole period.
  Vec3 low;
  Vec3 high;
  std::array<bool, 3> periodic{};  ///< by axis
  double inlet_area = 0.0;         ///< of the whole face [m^2]
  double colloid_radius = 0.0;     ///< a [m]
  double volume_fraction = 0.0;    ///< phi of the suspension [-]; 0: no colloids
  double capture_gap = 0.0;        ///< least gap to walls, grains and other colloids [m]
  std::vector<Sphere> grains;      ///< fixed spheres that a colloid at the inlet may meet
};

struct InjectedColloid {
  int index = 0;
  double volume = 0.0;  ///< of suspension injected before it [m^3]
  Vec3 position;        ///< of its centre [m]
  int redraws = 0;      ///< positions refused before this one
};

/// The colloids of one realisation, found when asked for.
class InjectionSequence {
 public:
  InjectionSequence(InjectionPlan plan, std::uint64_t seed);

  /// Colloid `index` >= 0, the same whatever was asked before; the reference stays valid.
  /// With phi = 0 every volume is infinite.  Refuses (InputError) an inlet so crowded
  /// that 10,000 positions were refused.
  const InjectedColloid& at(int index);

  const InjectionPlan& plan() const { return plan_; }
  std::uint64_t seed() const { return random_.seed(); }

 private:
  enum class Obstacle { none, grain, colloid };
  InjectedColloid next() const;
  Vec3 draw_position(const RandomAddress& at) const;
  Obstacle obstacle_at(const Vec3& position, double volume) const;
  double distance(const Vec3& a, const Vec3& b) const;

  InjectionPlan plan_;
  Random random_;
  std::deque<InjectedColloid> colloids_;
};

}  // namespace colloid
