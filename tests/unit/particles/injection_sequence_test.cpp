#include "particles/injection_sequence.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "core/constants.h"
#include "core/error.h"
#include "statistics.h"

namespace colloid {
namespace {

using testing::HasSubstr;

// Reference scene: throat of 96.6 um, colloids of 13.3 um, phi = 0.005, 0.5 mm/s.
constexpr double kWidth = 96.6e-6;
constexpr double kHeight = 144.9e-6;
constexpr double kRadius = 6.65e-6;
constexpr double kGap = 13e-9;
constexpr double kFlowRate = 0.5e-3 * kWidth * kWidth;
constexpr double kVolume = 4.0 / 3.0 * kPi * kRadius * kRadius * kRadius;

constexpr double kDeviations = 4.892;  // two-sided kFalseAlarm of a normal variable

InjectionPlan throat_plan(double volume_fraction = 0.005) {
  InjectionPlan plan;
  plan.inlet_face = z_plus;
  plan.low = {kRadius + kGap, kRadius + kGap, kHeight - kRadius};
  plan.high = {kWidth - kRadius - kGap, kWidth - kRadius - kGap, kHeight - kRadius};
  plan.inlet_area = kWidth * kWidth;
  plan.colloid_radius = kRadius;
  plan.volume_fraction = volume_fraction;
  plan.capture_gap = kGap;
  return plan;
}

InjectionPlan periodic_plan(double volume_fraction) {
  InjectionPlan plan = throat_plan(volume_fraction);
  plan.periodic = {true, true, false};
  plan.low = {0.0, 0.0, kHeight - kRadius};
  plan.high = {kWidth, kWidth, kHeight - kRadius};
  return plan;
}

bool same(const InjectedColloid& a, const InjectedColloid& b) {
  return a.index == b.index && a.volume == b.volume && a.position == b.position &&
         a.redraws == b.redraws;
}

struct Expected {
  double volume, y, z;
  int redraws;
};

// Reference: injection_reference.py (arguments: injections), beside this file: its own
// Philox, its own geometry.  Inlet x-, y periodic, z between walls, a grain near the
// inlet, phi = 0.2, so that many positions are redrawn.
// Tolerance: rounding; 24 sums and a logarithm, a few ulp each: 1e-14.
TEST(InjectionSequence, ReproducesTheReference) {
  const Expected kExpected[] = {
      {5.517604558409022e-15, 3.922381418519469e-05, 1.0957708271853327e-05, 0},
      {1.0823621017866323e-14, 2.874309221156267e-05, 6.1795906335573954e-06, 0},
      {1.1871044959142613e-14, 4.171968307565792e-05, 2.4790220762118287e-05, 0},
      {1.2042927468362402e-14, 1.8070985818592812e-05, 3.616034674177103e-05, 1},
      {1.2869453351796598e-14, 3.1399187126158693e-05, 3.729356298672609e-05, 2},
      {1.7575284228469854e-14, 3.0896631742650824e-05, 2.130576025682752e-05, 2},
      {2.162147056933018e-14, 5.315266555780249e-06, 6.393080633600657e-06, 2},
      {2.2848651766286327e-14, 4.919313974932914e-05, 4.154347598076573e-05, 0},
      {2.3422755167071847e-14, 4.816546871846155e-05, 8.731579133511358e-06, 45},
      {3.228092556936126e-14, 2.348118395039979e-05, 1.321413528396553e-05, 4},
      {3.661542570865635e-14, 3.473511280585636e-05, 5.540852337394163e-06, 16},
      {3.8320387486786e-14, 4.2792583150603896e-05, 1.584148150700735e-05, 7},
      {4.120541047519472e-14, 1.5930535789323612e-05, 4.331364859888604e-05, 2},
      {4.19641889768418e-14, 3.0227672247315296e-05, 2.901778731334119e-05, 7},
      {4.3390428025393196e-14, 2.805250648397766e-05, 3.882824989699991e-05, 0},
      {4.363600001681758e-14, 4.2010523909041156e-05, 3.35278698139094e-05, 20},
      {4.4510200578577655e-14, 3.946654420694726e-06, 4.227960237600956e-05, 8},
      {4.626373247508643e-14, 1.941689674695725e-05, 2.8998228674215017e-05, 13},
      {5.2332493377819795e-14, 3.24383419557882e-05, 1.5541169635675392e-05, 3},
      {5.366209209594914e-14, 5.1223076832540697e-05, 4.4651257178162775e-05, 4},
      {5.446735449179477e-14, 3.724145108931081e-06, 7.417389080949915e-06, 6},
      {5.802176217685988e-14, 2.2448255656556884e-05, 1.9384699955441077e-05, 9},
      {5.807978099847177e-14, 2.5598337247542983e-05, 6.853362606600309e-06, 16},
      {6.122383100118408e-14, 3.951768824717364e-05, 4.130406262495386e-05, 9},
  };
  InjectionPlan plan;
  plan.inlet_face = x_minus;
  plan.colloid_radius = 5e-6;
  plan.capture_gap = 2e-8;
  plan.volume_fraction = 0.2;
  plan.inlet_area = 60e-6 * 50e-6;
  plan.periodic = {false, true, false};
  plan.low = {5e-6, 0.0, 5.02e-6};
  plan.high = {5e-6, 60e-6, 44.98e-6};
  plan.grains = {{{9e-6, 1e-6, 25e-6}, 12e-6}};
  InjectionSequence sequence(plan, 987654321987654321U);
  int index = 0;
  for (const Expected& expected : kExpected) {
    const InjectedColloid& colloid = sequence.at(index);
    EXPECT_EQ(colloid.index, index);
    EXPECT_NEAR(colloid.volume / expected.volume, 1.0, 1e-14);
    EXPECT_EQ(colloid.position.x, 5e-6);
    EXPECT_NEAR(colloid.position.y / expected.y, 1.0, 1e-14);
    EXPECT_NEAR(colloid.position.z / expected.z, 1.0, 1e-14);
    EXPECT_EQ(colloid.redraws, expected.redraws) << index;
    ++index;
  }
}

TEST(InjectionSequence, GapsInVolumeAreExponential) {
  InjectionSequence sequence(throat_plan(), 1);
  std::vector<double> gaps;
  double before = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double volume = sequence.at(i).volume;
    gaps.push_back(volume - before);
    before = volume;
  }
  expect_distributed(gaps,
                     [](double gap) { return -std::expm1(-gap * 0.005 / kVolume); });
}

// 400 realisations of 5 s.  Counts are Poisson of mean phi Q T / V_p = 94.7 (18.94 per
// second): the sum is normal within its standard error, the dispersion index chi-squared.
TEST(InjectionSequence, NinetyFiveEnterTheReferenceSceneInFiveSeconds) {
  const double rate = 0.005 * kFlowRate / kVolume;
  EXPECT_NEAR(rate, 18.94, 0.005);
  constexpr int kRealisations = 400;
  std::vector<int> counts;
  double total = 0.0;
  for (int seed = 0; seed < kRealisations; ++seed) {
    InjectionSequence sequence(throat_plan(), static_cast<std::uint64_t>(seed));
    int count = 0;
    while (sequence.at(count).volume <= 5.0 * kFlowRate) {
      ++count;
    }
    counts.push_back(count);
    total += count;
  }
  const double mean = total / kRealisations;
  const double expected = 5.0 * rate;
  EXPECT_NEAR(mean, expected, kDeviations * std::sqrt(expected / kRealisations));
  EXPECT_EQ(std::lround(expected), 95);
  double dispersion = 0.0;
  for (const int count : counts) {
    dispersion += (count - mean) * (count - mean) / mean;
  }
  expect_chi_squared(dispersion, kRealisations - 1);
}

// At a volume fraction of 1e-9 nothing is ever redrawn; the first colloid never is.
TEST(InjectionSequence, PositionsFillTheRectangleEvenly) {
  for (const InjectionPlan& plan : {throat_plan(1e-9), periodic_plan(1e-9)}) {
    InjectionSequence sequence(plan, 11);
    constexpr int kBins = 20;
    std::vector<int> counts(static_cast<std::size_t>(kBins) * kBins);
    std::vector<double> across;
    std::vector<double> along;
    for (int i = 0; i < 20000; ++i) {
      const InjectedColloid& colloid = sequence.at(i);
      ASSERT_EQ(colloid.redraws, 0);
      ASSERT_EQ(colloid.position.z, kHeight - kRadius);
      const Vec3 width = plan.high - plan.low;
      across.push_back((colloid.position.x - plan.low.x) / width.x);
      along.push_back((colloid.position.y - plan.low.y) / width.y);
      ASSERT_TRUE(across.back() > 0.0 && across.back() < 1.0);
      ASSERT_TRUE(along.back() > 0.0 && along.back() < 1.0);
      ++counts[bin_of(across.back(), kBins) * kBins + bin_of(along.back(), kBins)];
    }
    expect_equal_chances(counts);
    expect_distributed(across, [](double u) { return u; });
    expect_distributed(along, [](double u) { return u; });
  }
}

/// In plug flow all colloids stand in one column, each V/A above the first.  The least
/// gap of all pairs, images included where periodic.
double least_gap(InjectionSequence& sequence, int count) {
  const InjectionPlan& plan = sequence.plan();
  double least = HUGE_VAL;
  for (int i = 0; i < count; ++i) {
    const InjectedColloid a = sequence.at(i);
    for (int j = 0; j < i; ++j) {
      const InjectedColloid b = sequence.at(j);
      for (int m = -1; m <= 1; ++m) {
        for (int n = -1; n <= 1; ++n) {
          if ((m != 0 && !plan.periodic[0]) || (n != 0 && !plan.periodic[1])) {
            continue;
          }
          const Vec3 between{a.position.x - b.position.x + m * kWidth,
                             a.position.y - b.position.y + n * kWidth,
                             (a.volume - b.volume) / plan.inlet_area};
          least = std::min(least, norm(between) - 2.0 * kRadius);
        }
      }
    }
  }
  return least;
}

int redraws(InjectionSequence& sequence, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i) {
    sum += sequence.at(i).redraws;
  }
  return sum;
}

TEST(InjectionSequence, NoTwoColloidsOverlapInPlugFlow) {
  constexpr int kCount = 600;
  for (const InjectionPlan& plan : {throat_plan(0.15), periodic_plan(0.15)}) {
    InjectionSequence sequence(plan, 5);
    EXPECT_GE(least_gap(sequence, kCount), kGap * (1.0 - 1e-9));
    EXPECT_GT(redraws(sequence, kCount), kCount);  // or the test is void
  }
}

// Grains block two discs of the inlet, so a draw is refused with chance q = their share
// of it, and the redraws of a colloid are geometric: mean q/(1-q), variance q/(1-q)^2.
TEST(InjectionSequence, NoColloidOverlapsAGrain) {
  InjectionPlan plan = periodic_plan(1e-9);
  // One reaches across the corner: three of its four parts are periodic images.
  plan.grains = {{{50e-6, 40e-6, kHeight - 10e-6}, 25e-6},
                 {{2e-6, 3e-6, kHeight - kRadius}, 8e-6}};
  InjectionSequence sequence(plan, 5);
  double least = HUGE_VAL;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 x = sequence.at(i).position;
    for (const Sphere& grain : plan.grains) {
      for (int m = -1; m <= 1; ++m) {
        for (int n = -1; n <= 1; ++n) {
          const Vec3 image = grain.center + Vec3{m * kWidth, n * kWidth, 0.0};
          least = std::min(least, norm(x - image) - grain.radius - kRadius);
        }
      }
    }
  }
  EXPECT_GE(least, kGap * (1.0 - 1e-9));
  EXPECT_LT(least, 1e-6);  // some come close

  double blocked = 0.0;
  for (const Sphere& grain : plan.grains) {
    const double contact = grain.radius + kRadius + kGap;
    const double above = grain.center.z - (kHeight - kRadius);
    blocked += kPi * (contact * contact - above * above);
  }
  const double q = blocked / (kWidth * kWidth);
  EXPECT_NEAR(redraws(sequence, 3000), 3000.0 * q / (1.0 - q),
              kDeviations * std::sqrt(3000.0 * q) / (1.0 - q));
}

TEST(InjectionSequence, IsTheSameWhateverTheOrderOfAsking) {
  InjectionSequence forwards(throat_plan(0.1), 3);
  InjectionSequence backwards(throat_plan(0.1), 3);
  const InjectedColloid& kept = backwards.at(0);
  for (int i = 99; i >= 0; --i) {
    backwards.at(i);
  }
  backwards.at(5000);
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(same(forwards.at(i), backwards.at(i))) << i;
  }
  EXPECT_EQ(&kept, &backwards.at(0));
}

// A colloid's gap and first position are addressed by its own index: redraws of others,
// here forced by a grain, change nothing of them.
TEST(InjectionSequence, RedrawsDoNotShiftWhatFollows) {
  InjectionPlan plan = throat_plan(1e-6);
  InjectionSequence open(plan, 8);
  plan.grains = {{{kWidth / 2, kWidth / 2, kHeight - kRadius}, 20e-6}};
  InjectionSequence hindered(plan, 8);
  int moved = 0;
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(open.at(i).volume, hindered.at(i).volume);
    EXPECT_EQ(open.at(i).position == hindered.at(i).position,
              hindered.at(i).redraws == 0);
    moved += hindered.at(i).redraws > 0 ? 1 : 0;
  }
  EXPECT_GT(moved, 20);
  EXPECT_LT(moved, 180);
}

TEST(InjectionSequence, DiffersFromSeedToSeed) {
  std::vector<double> volumes;
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 1ULL << 32U, 1ULL << 63U, ~0ULL}) {
    volumes.push_back(InjectionSequence(throat_plan(), seed).at(0).volume);
  }
  std::sort(volumes.begin(), volumes.end());
  EXPECT_EQ(std::adjacent_find(volumes.begin(), volumes.end()), volumes.end());
}

TEST(InjectionSequence, WithoutColloidsNothingEnters) {
  InjectionPlan plan = throat_plan(0.0);
  plan.grains = {{{0.0, 0.0, kHeight}, 1.0}};  // no place either, but none is needed
  InjectionSequence sequence(plan, 1);
  EXPECT_EQ(sequence.at(0).volume, HUGE_VAL);
  EXPECT_EQ(sequence.at(10).volume, HUGE_VAL);
}

std::string refusal(const InjectionPlan& plan, int count) {
  try {
    InjectionSequence(plan, 1).at(count);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(InjectionSequence, RefusesAnInletThatIsTooCrowded) {
  InjectionPlan plan = throat_plan(0.5);
  plan.inlet_area *= 4.0;  // colloids crowd in a quarter of it
  EXPECT_THAT(refusal(plan, 1000), HasSubstr("/colloids/volume_fraction: is 0.5: the "
                                             "inlet is too crowded"));
  EXPECT_THAT(refusal(plan, 1000), HasSubstr("10000 draws"));
  plan = throat_plan();
  plan.grains = {{{kWidth / 2, kWidth / 2, kHeight}, kWidth}};
  EXPECT_THAT(refusal(plan, 0), HasSubstr("/geometry: leaves a colloid no place"));
}

}  // namespace
}  // namespace colloid
