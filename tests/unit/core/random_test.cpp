#include "core/random.h"

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>

#include "core/constants.h"
#include "core/error.h"
#include "statistics.h"

namespace colloid {
namespace {

// Known answers of the authors' library: kat_vectors of Random123 1.14, "philox4x32 10".
TEST(Philox, GivesTheKnownAnswersOfItsAuthors) {
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t kOnes = 0xffffffff;
  EXPECT_EQ(philox4x32({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}),
            (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
                       {0xa4093822, 0x299f31d0}),
            (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// The same answer through a seed and an address: where each of their bits goes.
TEST(Random, PutsSeedAndAddressIntoKeyAndCounter) {
  const Random random(0x299f31d0a4093822);
  const RandomAddress at{static_cast<RandomPurpose>(0x03707344), 0x13198a2e,
                         0x85a308d3243f6a88};
  EXPECT_EQ(random.bits(at),
            (std::array<std::uint64_t, 2>{0x94fdccebd16cfe09, 0x24126ea15001e420}));
}

// By hand from the first and third known answers, whose words are 0xe169c58d6627e8d5,
// 0x9b00dbd8bc57ac4c and, the last, 0x24126ea15001e420: the upper 52 bits, a one after
// them (the last word has a zero there).
TEST(Random, TurnsBitsIntoExactlyThisDouble) {
  const auto [u, v] = Random(0).uniform_pair({static_cast<RandomPurpose>(0), 0, 0});
  EXPECT_EQ(u, 0x1c2d38b1acc4fdp-53);
  EXPECT_EQ(v, 0x13601b7b178af5p-53);
  const RandomAddress third{static_cast<RandomPurpose>(0x03707344), 0x13198a2e,
                            0x85a308d3243f6a88};
  EXPECT_EQ(Random(0x299f31d0a4093822).uniform_pair(third)[1], 0x4824dd42a003dp-53);
}

struct Draw {
  std::uint64_t seed;
  std::uint32_t purpose;
  std::uint32_t stream;
  std::uint64_t index;
  std::uint64_t first;
  std::uint64_t second;
  double exponential;
  double normal0;
  double normal1;
};

// From injection_reference.py (arguments: draws), in unit/particles.  These must never
// change: seeds in users' databases rely on them.
// Tolerance: integers none.  ln, cos, sin of two libraries differ by an ulp, and the
// angle below 2 pi is rounded by 2^-51: times the largest radius, 8.6, that is 4e-15 + an
// ulp of the result.
TEST(Random, DrawsTheSameForEver) {
  const Draw kDraws[] = {
      {0U, 1, 0U, 0U, 0x1348e23f2dce73e5, 0xa287aadbfcf8e0ec, 2.585865292291118,
       -1.505176051948169, -1.704750901810572},
      {1U, 1, 0U, 0U, 0x1e047488127bee41, 0x0a39349648842b20, 2.14340012667733,
       2.005620549900247, 0.5140879916633839},
      {1U, 2, 0U, 0U, 0x6b5c693b2fe424f7, 0x7d0e2e0a46220365, 0.8689806366045796,
       -1.3148761822510329, 0.09519400484330807},
      {1U, 3, 0U, 0U, 0xac25b124695407f3, 0xc6a6848363d480de, 0.39682732089463985,
       0.1447695204062709, -0.8790315283029488},
      {1U, 1, 1U, 0U, 0x657c46165f385a57, 0x4500ab6870e6d019, 0.9252620607273604,
       -0.16660677005644847, 1.350098628110583},
      {1U, 1, 0U, 1U, 0xa9634a0410cc6764, 0xf15e1f534506ae51, 0.41298639952934946,
       0.8508492671883993, -0.31941872766583806},
      {18446744073709551615U, 2, 4294967295U, 18446744073709551615U, 0x80a0578865a36705,
       0x154173c2a9c385d2, 0.688265866359479, 1.0171865877286421, 0.5846906690412625},
      {12345U, 2, 7U, 4294967296U, 0xebc2665fe264127f, 0xc06c12a7807ab009,
       0.08236575870194318, 0.004205302047519903, -0.40584951994375384},
  };
  for (const Draw& expected : kDraws) {
    const Random random(expected.seed);
    const RandomAddress at{static_cast<RandomPurpose>(expected.purpose), expected.stream,
                           expected.index};
    EXPECT_EQ(random.bits(at)[0], expected.first);
    EXPECT_EQ(random.bits(at)[1], expected.second);
    EXPECT_NEAR(random.exponential(at), expected.exponential, 1e-14);
    EXPECT_NEAR(random.normal_pair(at)[0], expected.normal0, 1e-14);
    EXPECT_NEAR(random.normal_pair(at)[1], expected.normal1, 1e-14);
  }
  EXPECT_EQ(static_cast<std::uint32_t>(RandomPurpose::injection), 1U);
  EXPECT_EQ(static_cast<std::uint32_t>(RandomPurpose::brownian), 2U);
  EXPECT_EQ(static_cast<std::uint32_t>(RandomPurpose::escape), 3U);
}

constexpr int kDraws = 200000;

/// The n-th address along one of the three ways through addresses, or the n-th seed.
enum class Along { index, stream, seed };

std::vector<std::array<double, 2>> uniform_draws(Along along, RandomPurpose purpose) {
  std::vector<std::array<double, 2>> draws;
  draws.reserve(kDraws);
  for (std::uint32_t n = 0; n < kDraws; ++n) {
    const Random random(along == Along::seed ? n : 2024);
    draws.push_back(random.uniform_pair(
        {purpose, along == Along::stream ? n : 3, along == Along::index ? n : 5}));
  }
  return draws;
}

/// Pairs fill the unit square evenly: each coordinate, and no dependence between them.
void expect_even_square(const std::vector<std::array<double, 2>>& pairs) {
  constexpr int kBins = 64;
  std::vector<int> counts(static_cast<std::size_t>(kBins) * kBins);
  for (const auto& [u, v] : pairs) {
    ASSERT_GT(std::min(u, v), 0.0);
    ASSERT_LT(std::max(u, v), 1.0);
    ++counts[bin_of(u, kBins) * kBins + bin_of(v, kBins)];
  }
  expect_equal_chances(counts);
}

TEST(Random, IsEvenAndIndependentAlongIndicesStreamsAndSeeds) {
  for (const Along along : {Along::index, Along::stream, Along::seed}) {
    SCOPED_TRACE(static_cast<int>(along));
    const auto draws = uniform_draws(along, RandomPurpose::injection);
    expect_even_square(draws);
    std::vector<std::array<double, 2>> neighbours;
    neighbours.reserve(draws.size() / 2);
    for (std::size_t n = 0; n + 1 < draws.size(); n += 2) {
      neighbours.push_back({draws[n][0], draws[n + 1][0]});
    }
    expect_even_square(neighbours);
  }
}

TEST(Random, IsIndependentBetweenPurposes) {
  const auto injection = uniform_draws(Along::index, RandomPurpose::injection);
  const auto brownian = uniform_draws(Along::index, RandomPurpose::brownian);
  const auto escape = uniform_draws(Along::index, RandomPurpose::escape);
  std::vector<std::array<double, 2>> first;
  std::vector<std::array<double, 2>> second;
  for (std::size_t n = 0; n < injection.size(); ++n) {
    first.push_back({injection[n][0], brownian[n][0]});
    second.push_back({brownian[n][1], escape[n][1]});
  }
  expect_even_square(first);
  expect_even_square(second);
}

TEST(Random, ExponentialDrawsAreExponential) {
  const Random random(7);
  std::vector<double> draws;
  draws.reserve(kDraws);
  for (std::uint64_t n = 0; n < kDraws; ++n) {
    draws.push_back(random.exponential({RandomPurpose::escape, 1, n}));
  }
  expect_distributed(draws, [](double x) { return -std::expm1(-x); });
}

TEST(Random, NormalDrawsAreNormalAndIndependent) {
  const Random random(7);
  std::vector<double> draws;
  std::vector<std::array<double, 2>> angles;
  double squares = 0.0;
  for (std::uint64_t n = 0; n < kDraws / 2; ++n) {
    const auto [x, y] = random.normal_pair({RandomPurpose::brownian, 12, n});
    draws.push_back(x);
    draws.push_back(y);
    squares += x * x + y * y;
    // Independent and normal: the angle and exp(-r^2/2) are even and independent.
    angles.push_back(
        {std::atan2(y, x) / (2.0 * kPi) + 0.5, std::exp(-0.5 * (x * x + y * y))});
  }
  expect_distributed(draws,
                     [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); });
  expect_even_square(angles);
  expect_chi_squared(squares, kDraws);
}

TEST(Seed, IsReadWithAllItsBits) {
  EXPECT_EQ(parse_seed("0", "s"), 0U);
  EXPECT_EQ(parse_seed("9007199254740993", "s"), 9007199254740993U);  // no double
  EXPECT_EQ(parse_seed("18446744073709551615", "s"),
            std::numeric_limits<std::uint64_t>::max());
}

TEST(Seed, IsRefusedUnlessAWholeNumberOf64Bits) {
  for (const char* text :
       {"", " ", "-1", "-0", "+1", "1.0", "1e3", "0x1", " 1", "1 ", "1,000",
        "18446744073709551616", "99999999999999999999999", "seed", "\xc2\xb2"}) {
    try {
      parse_seed(text, "--seed");
      ADD_FAILURE() << "accepted " << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), "--seed");
      EXPECT_THAT(error.why(), testing::HasSubstr("0 to 18446744073709551615"));
    }
  }
}

}  // namespace
}  // namespace colloid
