// Units: the symbols that quantities may use, and expressions of them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace colloid {

/// Powers of m, kg, s, A, K, mol.
struct Dimension {
  std::array<int, 6> power{};
};
inline bool operator==(const Dimension& a, const Dimension& b) {
  return a.power == b.power;
}

/// A unit is factor * 10^exponent10 * (kT)^thermal in SI.  The power of ten is kept apart
/// so that "13.3 um" is exactly the double nearest to 13.3e-6, not one rounding off it.
struct Unit {
  double factor = 1.0;
  int exponent10 = 0;
  int thermal = 0;  ///< power of kT
  Dimension dimension;
};

/// The unit of a symbol with or without a prefix ("um", "min", "kT"), if there is one.
std::optional<Unit> find_unit(std::string_view symbol);

/// The unit of an expression such as "kg/(m s)" (grammar: quantity.h).  Refuses with
/// `where` what is none; `wish` composes the end of that message.
Unit parse_unit(std::string_view text, const std::string& where,
                const std::function<std::string()>& wish);

/// What a dimension is called ("length"), or its SI base units ("kg m^2").
std::string name_of(const Dimension& dimension);

}  // namespace colloid
