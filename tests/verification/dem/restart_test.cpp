// A restored DEM goes on bit by bit as the one that was saved.
#include <cstring>

#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

bool same(const Vec3& a, const Vec3& b) {
  return std::memcmp(&a, &b, sizeof(Vec3)) == 0;
}

void expect_same(const std::vector<DemState>& a, const std::vector<DemState>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].held, b[i].held);
    EXPECT_TRUE(same(a[i].position, b[i].position)) << a[i].id;
    EXPECT_TRUE(same(a[i].velocity, b[i].velocity)) << a[i].id;
    EXPECT_TRUE(same(a[i].spin, b[i].spin)) << a[i].id;
  }
}

/// Everything is on: contacts with history, walls, surface forces, bonds, lubrication.
DemOptions everything(bool aggregates) {
  DemOptions options = bonding();
  options.box.size = {6e-5, 6e-5, 1.2e-4};
  options.box.faces[x_minus] = options.box.faces[x_plus] = FaceCondition::periodic;
  options.gravity = {0.0, 0.0, -9.81};
  options.surfaces.rules.grains_attach = aggregates;
  options.surfaces.rules.aggregates = aggregates;
  options.permanent_bonds = false;
  options.long_range_forces = true;
  options.lubrication = true;
  options.lubrication_cell = 5e-7;
  return options;
}

const std::vector<Sphere> kGrains{{{3e-5, 0.0, 3e-5}, 2e-5}, {{0.0, 3e-5, 9e-5}, 1e-5}};

void fill(Dem& dem) {
  int id = 0;
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 3; ++i, ++id) {
        const double s = 2.0 * kRadius + 3e-8;
        dem.add(
            {id * 3, {1.2e-5 + i * s, 3.1e-5 + j * s, kRadius + 1e-8 + k * s}, {}, {}});
      }
    }
  }
}

std::vector<DemLoad> loads(const Dem& dem) {
  std::vector<DemLoad> out;
  for (const DemState& s : dem.states()) {
    if (!s.held) {
      const double x = 1e5 * s.position.y;
      DemLoad load =
          stokes_drag(s.id, {2e-3 * std::sin(x), -3e-3, -5e-3 + 2e-3 * std::cos(s.id)});
      load.spin = {0.0, 20.0, -40.0};
      out.push_back(load);
    }
  }
  return out;
}

/// Interval by interval; returns what happened in all.
std::vector<DemStep> go(Dem& dem, int intervals) {
  std::vector<DemStep> steps;
  for (int i = 0; i < intervals; ++i) {
    steps.push_back(dem.advance(1.237e-5, loads(dem)));
  }
  return steps;
}

void expect_same(const std::vector<DemStep>& a, const std::vector<DemStep>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].events.size(), b[i].events.size());
    for (std::size_t e = 0; e < a[i].events.size(); ++e) {
      EXPECT_EQ(a[i].events[e].kind, b[i].events[e].kind);
      EXPECT_EQ(a[i].events[e].colloid, b[i].events[e].colloid);
      EXPECT_EQ(a[i].events[e].other, b[i].events[e].other);
      EXPECT_EQ(a[i].events[e].time, b[i].events[e].time);
    }
    ASSERT_EQ(a[i].means.size(), b[i].means.size());
    for (std::size_t m = 0; m < a[i].means.size(); ++m) {
      EXPECT_TRUE(same(a[i].means[m].force, b[i].means[m].force));
      EXPECT_TRUE(same(a[i].means[m].torque, b[i].means[m].torque));
    }
  }
}

class DemRestart : public ::testing::TestWithParam<bool> {};

TEST_P(DemRestart, ContinuesBitByBit) {
  const DemOptions options = everything(GetParam());
  Dem undisturbed(options, kGrains);
  fill(undisturbed);
  go(undisturbed, 8);
  undisturbed.remove(9);
  const std::vector<DemStep> expected = go(undisturbed, 8);

  Dem first(options, kGrains);
  fill(first);
  go(first, 8);
  first.remove(9);
  const std::string saved = first.save();
  expect_same(expected, go(first, 8));  // saving disturbs nothing
  expect_same(undisturbed.states(), first.states());

  Dem second(options, kGrains);
  second.restore(saved);
  expect_same(expected, go(second, 8));
  expect_same(undisturbed.states(), second.states());
  EXPECT_EQ(undisturbed.bonds_broken(), second.bonds_broken());
  ASSERT_EQ(undisturbed.bonds().size(), second.bonds().size());
  // The test has what it is for.
  double turned = 0.0;
  for (const DemState& s : second.states()) {
    turned = std::max(turned, norm(s.spin));
  }
  EXPECT_GT(turned, 1.0);
  if (GetParam()) {
    EXPECT_FALSE(second.bonds().empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Aggregates, DemRestart, ::testing::Bool());

TEST(DemRestart, OfBondsUnderLoadContinuesBitByBit) {
  const DemOptions options = bonding();
  const double length = 2.0 * kRadius + 3e-9;
  std::vector<DemLoad> loads{stokes_drag(1, {}, {1e-9, 0.0, 0.0}),
                             stokes_drag(3, {}, {0.0, 0.0, 2e-9})};
  loads[1].torque = {0.0, 1e-15, 2e-15};
  Dem first(options, {});
  first.add({0, kMiddle, {}, {}, true});
  first.add({1, kMiddle + Vec3{0.0, length, 0.0}, {}, {}});
  first.add({3, {5e-5, 5e-5, 5e-5}, {}, {}});
  first.add({4, {5e-5 + length, 5e-5, 5e-5}, {}, {}});
  first.advance(5e-5, loads);
  ASSERT_EQ(first.bonds().size(), 2U);
  Dem second(options, {});
  second.restore(first.save());
  for (Dem* dem : {&first, &second}) {
    dem->advance(5e-5, loads);
  }
  expect_same(first.states(), second.states());
  EXPECT_GT(norm(first.states().at(1).spin), 1.0);
}

TEST(DemRestart, OfRetainedColloidsAloneWorks) {
  DemOptions options = everything(true);
  options.surfaces.rules.grains_attach = false;
  options.permanent_bonds = true;
  options.lubrication = false;  // would keep the newcomer away for longer
  Dem first(options, kGrains);
  first.add({4, {1e-5, 3e-5, 9e-5}, {}, {}, true});
  first.add({2, {1e-5 + 2.0 * kRadius + 2e-9, 3e-5, 9e-5}, {}, {}});
  first.advance(1e-6, {});
  ASSERT_EQ(first.bonds().size(), 1U);
  first.hold(2);
  Dem second(options, kGrains);
  second.restore(first.save());
  EXPECT_EQ(second.bonds().size(), 1U);
  expect_same(first.states(), second.states());
  for (Dem* dem : {&first, &second}) {
    dem->add({7, {1e-5 + kRadius + 1e-9, 3e-5, 9e-5 + 1.153e-5}, {0.0, 0.0, -1e-3}, {}});
    go(*dem, 3);
  }
  EXPECT_GT(first.bonds().size(), 1U);
  expect_same(first.states(), second.states());
}

TEST(DemRestart, OfAnEmptyBoxWorks) {
  const DemOptions options = bonding();
  Dem first(options, {});
  first.advance(1e-5, {});
  Dem second(options, {});
  second.restore(first.save());
  second.add({0, kMiddle, {1e-3, 0.0, 0.0}, {}});
  first.add({0, kMiddle, {1e-3, 0.0, 0.0}, {}});
  first.advance(1e-5, {});
  second.advance(1e-5, {});
  expect_same(first.states(), second.states());
}

}  // namespace
}  // namespace colloid::dem_test
