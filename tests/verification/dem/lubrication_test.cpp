// Approach under a constant force against sub-grid lubrication alone.
// Reference  h' = -F / (6 pi mu R^2 (1/h - s(h/d)/d)), s the flow's share, d its cell:
//            ln(h/h_0) + integral of s = -F t / (6 pi mu R^2), R = a at a wall, a/2 for
//            two colloids.
// Tolerance  with rate = F/(6 pi mu R^2): positions follow velocities explicitly, ln h is
//            off by rate t rate step / 2 (twice that near the cut: asked for below
//            twice); inertia adds m/resistance rate, below 1e-3 here and the same at both
//            steps, so the difference of two steps is asked for too.
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "dem_case.h"
#include "physics/pair_resistance.h"
#include "physics/wall_resistance.h"
#include "tiers/transient/dem_lubrication.h"

namespace colloid::dem_test {
namespace {

constexpr double kCell = 2e-6;
constexpr double kStart = 2e-7;
constexpr double kPush = 5e-10;  // on a colloid at a wall; less where less resists

DemOptions lubricated(double step) {
  DemOptions options = inert();
  options.lubrication = true;
  options.lubrication_cell = kCell;
  options.step = step;
  return options;
}

/// ln(h/h_0) that the law gives after `turns` = rate t.
double law(double turns) {
  const auto turned = [](double y) {
    double resolved = 0.0;  // midpoints of what the flow has
    constexpr int kPoints = 2000;
    const double start = kStart / kCell;
    const double width = start * (1.0 - std::exp(y)) / kPoints;
    for (int i = 0; i < kPoints; ++i) {
      resolved += width * resolved_resistance(start - (i + 0.5) * width);
    }
    return -y - resolved;
  };
  double low = -2.0 * turns;
  double high = 0.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (turned(middle) > turns ? low : high) = middle;
  }
  return low;
}

void expect_law(double radius, const std::function<double(double, double)>& gap_after) {
  const double rate = kPush / (6.0 * kPi * kViscosity * kRadius * kRadius);
  const double turns = 3.0;
  double error[2] = {0.0, 0.0};
  const double steps[2] = {5e-8, 2.5e-8};
  for (int i = 0; i < 2; ++i) {
    error[i] = std::log(gap_after(steps[i], turns / rate) / kStart) - law(turns);
    const double inertia =
        rate * kMass * kStart / (6.0 * kPi * kViscosity * radius * radius);
    EXPECT_LT(inertia, 2e-3);
    EXPECT_LT(std::abs(error[i]), turns * rate * steps[i] + 2.0 * inertia);
  }
  EXPECT_LT(std::abs(error[0] - error[1]), turns * rate * (steps[0] - steps[1]));
}

TEST(DemLubrication, SlowsTheApproachToAWall) {
  expect_law(kRadius, [](double step, double time) {
    Dem dem(lubricated(step), {});
    dem.add({0, {1e-4, 1e-4, kRadius + kStart}, {}, {}});
    DemLoad load;
    load.id = 0;
    load.force = {0.0, 0.0, -kPush};
    const DemStep taken = dem.advance(time, {load});
    // What the load brings, lubrication takes; little is left as momentum.
    EXPECT_NEAR(taken.means.at(0).force.z / kPush, 1.0, 1e-3);
    EXPECT_EQ(dem.states().at(0).position.x, 1e-4);
    return dem.states().at(0).position.z - kRadius;
  });
}

TEST(DemLubrication, SlowsTheApproachOfTwoColloids) {
  expect_law(0.5 * kRadius, [](double step, double time) {
    Dem dem(lubricated(step), {});
    const Vec3 apart{kRadius + 0.5 * kStart, 0.0, 0.0};
    dem.add({0, kMiddle - apart, {}, {}});
    dem.add({1, kMiddle + apart, {}, {}});
    DemLoad left;
    left.id = 0;
    left.force = {0.25 * kPush, 0.0, 0.0};
    DemLoad right;
    right.id = 1;
    right.force = -left.force;
    const DemStep taken = dem.advance(time, {left, right});
    EXPECT_NEAR(taken.means.at(0).force.x + taken.means.at(1).force.x, 0.0, 1e-8 * kPush);
    const std::vector<DemState> s = dem.states();
    return norm(s.at(1).position - s.at(0).position) - 2.0 * kRadius;
  });
}

Matrix12 approach_of_two(double r) {
  Matrix12 out = Matrix12::Zero();
  out(0, 0) = out(6, 6) = r;
  out(0, 6) = out(6, 0) = -r;
  return out;
}

Matrix6 approach_to_plane(double r) {
  Matrix6 out = Matrix6::Zero();
  out(0, 0) = r;
  return out;
}

TEST(DemLubrication, IsSolvedForARowBetweenTwoPlanes) {
  // Three colloids in a row, gaps at both ends: four equations by hand, C = 1.
  // v_i + r (v_i - v_(i-1)) + r (v_i - v_(i+1)) = u_i with v = 0 at the planes, but for
  // the last, which moves at w.
  const double w = 0.75;
  for (const double r : {0.1, 10.0, 1000.0}) {
    std::vector<NarrowGap> gaps{
        narrow_gap(0, approach_to_plane(r)), narrow_gap(1, 0, approach_of_two(r)),
        narrow_gap(2, 1, approach_of_two(r)), narrow_gap(2, approach_to_plane(r))};
    gaps.back().drive[0] = r * w;
    std::vector<Vector6> v(3, Vector6::Zero());
    v[0][0] = 1.0;
    v[0][1] = 0.5;
    v[1][0] = -2.0;
    v[2][0] = 4.0;
    v[2][5] = 0.25;
    solve_lubrication(gaps, std::vector<Vector6>(3, Vector6::Ones()), v);
    const double b = 1.0 + 2.0 * r;
    const double last = 4.0 + r * w;
    const double middle = (-2.0 + r / b * (1.0 + last)) / (b - 2.0 * r * r / b);
    EXPECT_NEAR(v[1][0], middle, 1e-6);
    EXPECT_NEAR(v[0][0], (1.0 + r * middle) / b, 1e-6);
    EXPECT_NEAR(v[2][0], (last + r * middle) / b, 1e-6);
    EXPECT_EQ(v[0][1], 0.5);
    EXPECT_EQ(v[2][5], 0.25);
    // What is at rest feels the gap, and does not move.
    std::vector<NarrowGap> held{narrow_gap(0, -1, approach_of_two(r))};
    std::vector<Vector6> alone(1, Vector6::Ones());
    solve_lubrication(held, {Vector6::Ones()}, alone);
    EXPECT_NEAR(alone[0][0], 1.0 / (1.0 + r), 1e-12);
    EXPECT_NEAR(held[0].wrench[6], r / (1.0 + r), 1e-12);
  }
}

// What (T-D5) leaves of (R1) at the gap: f_t, t_t and t_r of the wall.
WallResistance missing_at_wall(double gap) {
  const WallResistance all = wall_resistance(gap / kRadius);
  const WallResistance seen = wall_resistance(
      kCell * gap_seen_by_sliding(gap / kCell, kSeenBesidePlane) / kRadius);
  WallResistance out;
  out.f_t = all.f_t - seen.f_t;
  out.t_t = all.t_t - seen.t_t;
  out.t_r = all.t_r - seen.t_r;
  return out;
}

// Pulled along a surface with no resistance but Stokes' and (T-D5): the steady motion of
// (R1), two equations, 6 pi mu a [(1 + f) v - 4/3 t aw] = F,  (1 + r) aw = t v.
void expect_rolling(Dem& dem, const DemState& start, const WallResistance& w) {
  dem.add(start);
  const double push = 1e-4 * kPush;  // which moves it by less than a nanometre
  const DemLoad pull = stokes_drag(0, {}, {push, 0.0, 0.0});
  const double spin_per_speed = w.t_t / (1.0 + w.t_r);
  const double speed = push / kDrag / (1.0 + w.f_t - 4.0 / 3.0 * w.t_t * spin_per_speed);
  dem.advance(1e-3, {pull});  // a hundred relaxation times
  const DemStep taken = dem.advance(1e-5, {pull});
  const DemState s = dem.states().at(0);
  EXPECT_NEAR(s.velocity.x / speed, 1.0, 1e-6);
  EXPECT_NEAR(s.spin.y * kRadius / speed, spin_per_speed, 1e-6);
  const DemMean& mean = taken.means.at(0);
  EXPECT_NEAR(mean.force.x, -(push - kDrag * speed), 1e-6 * push);
  EXPECT_NEAR(mean.torque.y, kTorsion * s.spin.y, 1e-6 * push * kRadius);
}

TEST(DemLubrication, SlowsSlidingAlongAWallAndMakesTheColloidRoll) {
  for (const double gap : {2e-8, 2e-7, 1e-6}) {
    for (const double step : {5e-8, 2.5e-8}) {
      Dem dem(lubricated(step), {});
      expect_rolling(dem, {0, {1e-4, 1e-4, kRadius + gap}, {}, {}}, missing_at_wall(gap));
    }
  }
}

TEST(DemLubrication, SlowsSlidingAlongAGrain) {
  const double b = 20.3e-6;
  const double ratio = b / kRadius;
  const double gap = 2e-7;
  const TwoSphereResistance pair(ratio);
  const double mean = 0.5 * (1.0 + ratio) * kRadius;
  const PairResistance all = pair.at(gap / mean);
  const PairResistance seen =
      pair.at(kCell * gap_seen_by_sliding(gap / kCell, kSeenBesideSphere) / mean);
  WallResistance w;
  w.f_t = all.ya11 - seen.ya11;
  w.t_t = -0.5 * (all.yb11 - seen.yb11);
  w.t_r = all.yc11 - seen.yc11;
  Dem dem(lubricated(5e-8), {{kMiddle, b}});
  expect_rolling(dem, {0, kMiddle + Vec3{0.0, 0.0, b + kRadius + gap}, {}, {}}, w);
}

TEST(DemLubrication, RefusesGrainsForWhichThereIsNoResistance) {
  try {
    Dem dem(lubricated(5e-8), {{kMiddle, kRadius / 25.0}});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/fidelity/lubrication"), std::string::npos)
        << error.what();
  }
}

TEST(DemLubrication, DragsAlongAWallThatMoves) {
  const double gap = 2e-7;
  const WallResistance w = missing_at_wall(gap);
  DemOptions options = lubricated(5e-8);
  options.upper_wall_speed = 1e-4;
  Dem dem(options, {});
  dem.add({0, {1e-4, 1e-4, 2e-4 - kRadius - gap}, {}, {}});
  dem.advance(1e-3, {stokes_drag(0, {})});
  // Seen from the wall the liquid drags with -speed.
  const double spin_per_speed = w.t_t / (1.0 + w.t_r);
  const double slip =
      -options.upper_wall_speed / (1.0 + w.f_t - 4.0 / 3.0 * w.t_t * spin_per_speed);
  const DemState s = dem.states().at(0);
  EXPECT_NEAR(s.velocity.x - options.upper_wall_speed, slip,
              1e-6 * options.upper_wall_speed);
  EXPECT_NEAR(s.spin.y * kRadius, -spin_per_speed * slip,
              1e-6 * options.upper_wall_speed);
}

TEST(DemLubrication, OfTwoColloidsResistsTheirSlipAndLeavesTheRest) {
  const GapResistance gaps(kViscosity, kRadius, {}, kCell, 1e-10);
  const double leading = 6.0 * kPi * kViscosity * kRadius;
  const auto resists = [&](const Vector12& motion, double gap) {
    const Vec3 offset{0.0, 0.0, 2.0 * kRadius + gap};
    return motion.dot(gaps.between(offset) * motion) / leading;
  };
  Vector12 together = Vector12::Zero();  // v_x of both
  together[0] = together[6] = 1.0;
  Vector12 around = Vector12::Zero();  // as one body about the y axis of the gap
  around << 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, 1, 0;
  Vector12 slip = Vector12::Zero();
  slip[0] = 1.0;
  slip[6] = -1.0;
  // Jeffrey & Onishi (1984): the logarithm's coefficients are 1/6 (ya11) and -1/6 (ya12)
  // of ln(1/xi), hence 2/3 for the slip of both; none where the two move as one body.
  const double before = resists(slip, 1e-8);
  EXPECT_NEAR(resists(slip, 1e-9) - before, 2.0 / 3.0 * std::log(10.0), 0.01);
  for (const Vector12& rigid : {together, around}) {
    EXPECT_NEAR(resists(rigid, 1e-9) - resists(rigid, 1e-8), 0.0, 0.01);
    EXPECT_LT(std::abs(resists(rigid, 1e-9)), 0.05);
  }
  // It is symmetric, and at rest beyond its reach.
  const Matrix12 oblique = gaps.between({5e-6, 9e-6, 9e-6});
  EXPECT_NEAR((oblique - oblique.transpose()).norm(), 0.0, 1e-12 * oblique.norm());
  EXPECT_LT(gaps.between({2.0 * kRadius + 3.0 * kCell, 0.0, 0.0}).norm(), 0.01 * leading);
}

TEST(DemLubrication, IsWhatTheFlowLeavesOfTheExactPole) {
  const double leading = 6.0 * kPi * kViscosity * kRadius * kRadius;
  const auto at = [](double gap, double floor) {
    return lubrication_resistance(kViscosity, kRadius, gap, kCell, floor);
  };
  EXPECT_EQ(at(kResolvedGap * kCell, 1e-10), 0.0);
  // Narrow gaps: the pole; the flow has less than two over a cell of it.
  EXPECT_NEAR(at(1e-3 * kCell, 1e-10) * kCell / leading, 999.0, 1.0);
  EXPECT_EQ(at(-1e-9, 1e-10), at(1e-10, 1e-10));
  // It and the flow's share make the pole, and go on without a jump.
  double before = 0.0;
  for (double x = 3.1; x > 0.001; x *= 0.99) {
    const double missing = at(x * kCell, 1e-10) * kCell / leading;
    EXPECT_NEAR(missing + resolved_resistance(x), 1.0 / x, 1e-9 / x);
    EXPECT_GE(missing, before - 1e-9) << x;
    EXPECT_LT(missing - before, 0.02 / x) << x;
    before = missing;
  }
}

}  // namespace
}  // namespace colloid::dem_test
