#include "core/random.h"

#include <charconv>
#include <cmath>

#include "core/constants.h"
#include "core/error.h"
#include "core/text.h"

namespace colloid {

namespace {

// Salmon et al. (2011): multipliers of section 3.3, Weyl increments from the golden ratio
// and sqrt(3) - 1.
constexpr std::uint32_t kMultiplier0 = 0xD2511F53;
constexpr std::uint32_t kMultiplier1 = 0xCD9E8D57;
constexpr std::uint32_t kWeyl0 = 0x9E3779B9;
constexpr std::uint32_t kWeyl1 = 0xBB67AE85;
constexpr int kRounds = 10;

constexpr std::uint32_t low_word(std::uint64_t x) {
  return static_cast<std::uint32_t>(x & 0xFFFFFFFFU);
}
constexpr std::uint32_t high_word(std::uint64_t x) {
  return static_cast<std::uint32_t>(x >> 32U);
}

double uniform(std::uint64_t bits) {
  constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
  return static_cast<double>(((bits >> 12U) << 1U) | 1U) * kUnit;
}

}  // namespace

PhiloxCounter philox4x32(PhiloxCounter counter, PhiloxKey key) {
  for (int round = 0; round < kRounds; ++round) {
    const std::uint64_t p0 = static_cast<std::uint64_t>(kMultiplier0) * counter[0];
    const std::uint64_t p1 = static_cast<std::uint64_t>(kMultiplier1) * counter[2];
    counter = {high_word(p1) ^ counter[1] ^ key[0], low_word(p1),
               high_word(p0) ^ counter[3] ^ key[1], low_word(p0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

std::array<std::uint64_t, 2> Random::bits(const RandomAddress& at) const {
  const PhiloxCounter words =
      philox4x32({low_word(at.index), high_word(at.index), at.stream,
                  static_cast<std::uint32_t>(at.purpose)},
                 {low_word(seed_), high_word(seed_)});
  return {(static_cast<std::uint64_t>(words[1]) << 32U) | words[0],
          (static_cast<std::uint64_t>(words[3]) << 32U) | words[2]};
}

std::array<double, 2> Random::uniform_pair(const RandomAddress& at) const {
  const auto [first, second] = bits(at);
  return {uniform(first), uniform(second)};
}

double Random::exponential(const RandomAddress& at) const {
  return -std::log(uniform_pair(at)[0]);
}

std::array<double, 2> Random::normal_pair(const RandomAddress& at) const {
  const auto [u0, u1] = uniform_pair(at);
  const double radius = std::sqrt(-2.0 * std::log(u0));
  const double angle = 2.0 * kPi * u1;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::uint64_t parse_seed(std::string_view text, const std::string& where) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  require(error == std::errc() && rest == end, where, [&] {
    return "is " + in_quotes(text) +
           ", expected a whole number from 0 to 18446744073709551615";
  });
  return seed;
}

}  // namespace colloid
