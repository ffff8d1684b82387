// Resamples of n realisations with replacement, the same on every machine.
//
// std::mt19937_64 is specified bit by bit; std:: distributions are not, so the mapping to
// an index is ours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace colloid::statistics {

/// A seed of its own for each use of the campaign's seed: two rounds of SplitMix64
/// (Steele, Lea & Flood 2014), which is a bijection of `use` for each `seed`.
std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t use);

class Resampler {
 public:
  /// 1 <= n < 2^32.
  Resampler(std::size_t n, std::uint64_t seed);

  /// How often each realisation was drawn; the counts add up to n.  Counts and not
  /// indices: a resample that is a permutation of the sample then gives the sample's
  /// value exactly, which the ties of the BCa interval need.
  const std::vector<std::uint32_t>& draw();

 private:
  std::size_t index();

  std::mt19937_64 generator_;
  std::uint64_t n_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace colloid::statistics
