// Random samples of the coverage studies, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace colloid::statistics {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : generator_(seed) {}

  /// In (0, 1): the middles of 2^53 equal pieces.
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1.0p-53; }
  double exponential(double mean) { return -mean * std::log(uniform()); }
  /// Box & Muller 1958, the cosine of each pair.
  double normal() {
    constexpr double kTwoPi = 6.283185307179586;
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(kTwoPi * uniform());
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace colloid::statistics
