// Random numbers that are addressed, not consumed.
//
// A draw is a pure function of (seed, purpose, stream, index): it does not depend on what
// was drawn before, nor on threads, tiers or checkpoints.  Generator: Philox4x32-10 of
// Salmon, Moraes, Dror & Shaw (2011), "Parallel random numbers: as easy as 1, 2, 3",
// SC'11, doi:10.1145/2063384.2063405.  The key is the seed, the 128-bit counter is the
// address.  Integers and uniform draws are the same to the bit everywhere; draws that go
// through log, cos and sin are as good as the mathematical library.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace colloid {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// Ten rounds of Philox4x32.
PhiloxCounter philox4x32(PhiloxCounter counter, PhiloxKey key);

/// What a draw is for.  The values are part of every seed's meaning: never renumber them.
enum class RandomPurpose : std::uint32_t { injection = 1, brownian = 2, escape = 3 };

/// Where two draws stand.
struct RandomAddress {
  RandomPurpose purpose = RandomPurpose::injection;
  std::uint32_t stream = 0;  ///< whose: the index of a colloid
  std::uint64_t index = 0;   ///< which: a step; n pairs a step: n x step + pair
};

/// All random numbers of one realisation.
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t seed() const { return seed_; }

  /// The 128 bits at `at` as two words, the first from the generator's words 0 (low) and
  /// 1 (high), the second from 2 and 3.
  std::array<std::uint64_t, 2> bits(const RandomAddress& at) const;

  /// Two independent draws, uniform in (0, 1): u = (2 j + 1) / 2^53 with the upper 52
  /// bits j of each word.  So u has all 53 bits of a double, is never 0 or 1, and 1 - u
  /// is as likely as u.
  std::array<double, 2> uniform_pair(const RandomAddress& at) const;

  /// Exponential of mean 1: -ln u of the first uniform draw.
  double exponential(const RandomAddress& at) const;

  /// Two independent normal draws of mean 0 and variance 1, by Box & Muller (1958), Ann.
  /// Math. Stat. 29, 610: sqrt(-2 ln u0) (cos 2 pi u1, sin 2 pi u1).  |z| <= 8.58.
  std::array<double, 2> normal_pair(const RandomAddress& at) const;

 private:
  std::uint64_t seed_;
};

/// A seed as people and files write it: decimal digits, 0 to 2^64 - 1.  Refuses all else
/// with `where`.
std::uint64_t parse_seed(std::string_view text, const std::string& where);

}  // namespace colloid
