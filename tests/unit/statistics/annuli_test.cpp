#include "statistics/annuli.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/injection_profile.h"

namespace colloid::statistics {
namespace {

constexpr double kSide = 96.6e-6;  // of the reference throat's inlet [m]
constexpr double kWidth = 3e-6;

Annuli reference() {
  return Annuli({{0.0, kSide}, {0.0, kSide}}, kWidth);
}

// 48.3 um are 16 annuli of 3 um and one of 0.3 um.
TEST(Annuli, OfTheReferenceThroat) {
  const Annuli annuli = reference();
  ASSERT_EQ(annuli.size(), 17u);
  EXPECT_NEAR(annuli.outer(0), 3e-6, 1e-18);
  EXPECT_NEAR(annuli.area(0), 36e-12, 1e-22);
  EXPECT_NEAR(annuli.area(1), 108e-12, 1e-22);
  EXPECT_NEAR(annuli.centre(16), 48.15e-6, 1e-16);
  double total = 0.0;
  for (std::size_t i = 0; i < annuli.size(); ++i) {
    total += annuli.area(i);
  }
  EXPECT_NEAR(total, kSide * kSide, 1e-20);
}

TEST(Annuli, HaveNoSliverWhenTheWidthDividesTheSection) {
  for (double width : {1e-6, 3e-6, 7e-6, 0.1e-6}) {
    EXPECT_EQ(Annuli({{0.0, 20 * width}, {0.0, 20 * width}}, width).size(), 10u);
  }
  EXPECT_EQ(Annuli({{0.0, 1e-6}, {0.0, 1e-6}}, 3e-6).size(), 1u);
}

TEST(Annuli, PlaceIsByTheLargerDistance) {
  const Annuli annuli = reference();
  const double middle = kSide / 2;
  EXPECT_EQ(annuli.at({middle, middle}), 0u);
  EXPECT_EQ(annuli.at({middle + 2.9e-6, middle - 2.9e-6}), 0u);
  EXPECT_EQ(annuli.at({middle - 3.1e-6, middle}), 1u);
  EXPECT_EQ(annuli.at({middle + 1e-6, middle + 10e-6}), 3u);
  EXPECT_EQ(annuli.at({0.0, middle}), 16u);
  EXPECT_EQ(annuli.at({kSide, kSide}), 16u);
  EXPECT_THROW(annuli.at({-1e-6, middle}), InvalidSample);
  EXPECT_THROW(annuli.at({middle, std::nan("")}), InvalidSample);
}

TEST(Annuli, AreCutByTheNearerEdges) {
  const Annuli annuli({{0.0, 10e-6}, {-2e-6, 2e-6}}, 3e-6);
  ASSERT_EQ(annuli.size(), 2u);
  EXPECT_NEAR(annuli.area(0), 24e-12, 1e-22);
  EXPECT_NEAR(annuli.area(1), 16e-12, 1e-22);
  EXPECT_THROW(Annuli({{0.0, 0.0}, {0.0, 1.0}}, 1.0), InvalidSample);
  EXPECT_THROW(Annuli({{0.0, 1.0}, {0.0, 1.0}}, 0.0), InvalidSample);
  EXPECT_THROW(Annuli({{0.0, 1.0}, {0.0, 1.0}}, 1e-7), InvalidSample);
}

// Four realisations: the second retained colloid of one of them does not exist.
TEST(InjectionProfile, CountsRealisationsPerAnnulus) {
  const double m = kSide / 2;
  const std::vector<std::vector<std::array<double, 2>>> positions{
      {{m, m}, {m + 4e-6, m}},
      {{m, m + 1e-6}, {m, m + 5e-6}},
      {{m + 8e-6, m}, {m, m}},
      {{m, m - 4e-6}}};
  const InjectionProfile first = injection_profile(1, positions, reference(), 0.0, {});
  EXPECT_EQ(first.n, 4u);
  EXPECT_EQ(first.n_without, 0u);
  ASSERT_EQ(first.probability.size(), 17u);
  EXPECT_EQ(*first.probability[0].estimate, 0.5);
  EXPECT_EQ(*first.probability[1].estimate, 0.25);
  EXPECT_EQ(*first.probability[2].estimate, 0.25);
  EXPECT_NEAR(first.density[1], 0.25 / 108e-12, 1e-3);
  EXPECT_GT(first.probability[3].interval->high, 0.5);  // none of four excludes little
  const InjectionProfile second = injection_profile(2, positions, reference(), 0.0, {});
  EXPECT_EQ(second.n_without, 1u);
  EXPECT_EQ(*second.probability[1].estimate, 0.5);
}

// Centres stay 6.7 um from the edge, so the annuli from 42 um on are empty for geometry's
// sake; fitted are those whose centre is below 41.6 um: 14.
TEST(InjectionProfile, FitsWhatColloidsCanReach) {
  const std::vector<std::vector<std::array<double, 2>>> positions(
      3, {{kSide / 2, kSide / 2}});
  EXPECT_EQ(
      injection_profile(1, positions, reference(), 6.7e-6, {}).probability_fit.n_points,
      14u);
  EXPECT_EQ(injection_profile(1, positions, reference(), 0.0, {}).density_fit.n_points,
            17u);
}

}  // namespace
}  // namespace colloid::statistics
