#include "statistics/resampler.h"

#include <algorithm>
#include <limits>

#include "statistics/interval.h"

namespace colloid::statistics {

namespace {

std::uint64_t split_mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t use) {
  return split_mix(split_mix(seed) ^ use);
}

Resampler::Resampler(std::size_t n, std::uint64_t seed)
    : generator_(seed), n_(n), counts_(n) {
  if (n == 0 || n > std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidSample("resampling: " + std::to_string(n) +
                        " realisations, must be 1 to 2^32 - 1");
  }
}

const std::vector<std::uint32_t>& Resampler::draw() {
  std::fill(counts_.begin(), counts_.end(), 0u);
  for (std::uint64_t i = 0; i < n_; ++i) {
    ++counts_[index()];
  }
  return counts_;
}

// Uniform on 0 .. n-1 without bias: the high half of a 32 x 32 bit product, rejecting the
// 2^32 mod n low halves that would be too many (Lemire 2019, ACM TOMACS 29, 3).
std::size_t Resampler::index() {
  const std::uint64_t mask = 0xffffffffu;
  std::uint64_t product = (generator_() >> 32) * n_;
  if ((product & mask) < n_) {
    const std::uint64_t surplus = (mask + 1) % n_;
    while ((product & mask) < surplus) {
      product = (generator_() >> 32) * n_;
    }
  }
  return static_cast<std::size_t>(product >> 32);
}

}  // namespace colloid::statistics
