// Approach under a constant force against sub-grid lubrication alone.
// Reference  h' = -F / (6 pi mu R^2 (1/h - s(h/d)/d)), s the flow's share, d its cell:
//            ln(h/h_0) + integral of s = -F t / (6 pi mu R^2), R = a at a wall, a/2 for
//            two colloids.
// Tolerance  with rate = F/(6 pi mu R^2): positions follow velocities explicitly, ln h is
//            off by rate t rate step / 2 (twice that near the cut: asked for below
//            twice); inertia adds m/resistance rate, below 1e-3 here and the same at both
//            steps, so the difference of two steps is asked for too.
#include <functional>

#include <gtest/gtest.h>

#include "dem_case.h"
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

TEST(DemLubrication, IsSolvedForARowBetweenTwoPlanes) {
  // Three colloids in a row, gaps at both ends: four equations by hand, D = 1.
  // v_i + r (v_i - v_(i-1)) + r (v_i - v_(i+1)) = u_i with v = 0 at the planes.
  for (const double r : {0.1, 10.0, 1000.0}) {
    std::vector<NarrowGap> gaps{{0, -1, {1, 0, 0}, r, 0},
                                {1, 0, {1, 0, 0}, r, 0},
                                {2, 1, {1, 0, 0}, r, 0},
                                {2, -1, {1, 0, 0}, r, 0}};
    std::vector<Vec3> v{{1.0, 0.5, 0.0}, {-2.0, 0.0, 0.0}, {4.0, 0.0, 0.25}};
    solve_lubrication(gaps, {1.0, 1.0, 1.0}, v);
    const double b = 1.0 + 2.0 * r;
    const double middle = (-2.0 + r / b * (1.0 + 4.0)) / (b - 2.0 * r * r / b);
    EXPECT_NEAR(v[1].x, middle, 1e-6);
    EXPECT_NEAR(v[0].x, (1.0 + r * middle) / b, 1e-6);
    EXPECT_NEAR(v[2].x, (4.0 + r * middle) / b, 1e-6);
    EXPECT_EQ(v[0].y, 0.5);
    EXPECT_EQ(v[2].z, 0.25);
  }
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
