#include "core/units.h"

#include <array>
#include <string>

#include <fmt/format.h>

namespace colloid {

namespace {

struct Symbol {
  std::string_view name;
  bool takes_prefix;
  double factor;
  int exponent10;
  std::array<int, 6> power;  // m, kg, s, A, K, mol
};

// SI units, and those of other systems that the literature of this field prints.
constexpr std::array<Symbol, 27> kSymbols{{
    {"m", true, 1.0, 0, {1, 0, 0, 0, 0, 0}},
    {"g", true, 1.0, -3, {0, 1, 0, 0, 0, 0}},
    {"s", true, 1.0, 0, {0, 0, 1, 0, 0, 0}},
    {"A", true, 1.0, 0, {0, 0, 0, 1, 0, 0}},
    {"K", true, 1.0, 0, {0, 0, 0, 0, 1, 0}},
    {"mol", true, 1.0, 0, {0, 0, 0, 0, 0, 1}},
    {"N", true, 1.0, 0, {1, 1, -2, 0, 0, 0}},
    {"Pa", true, 1.0, 0, {-1, 1, -2, 0, 0, 0}},
    {"J", true, 1.0, 0, {2, 1, -2, 0, 0, 0}},
    {"W", true, 1.0, 0, {2, 1, -3, 0, 0, 0}},
    {"Hz", true, 1.0, 0, {0, 0, -1, 0, 0, 0}},
    {"V", true, 1.0, 0, {2, 1, -3, -1, 0, 0}},
    {"C", true, 1.0, 0, {0, 0, 1, 1, 0, 0}},
    {"F", true, 1.0, 0, {-2, -1, 4, 2, 0, 0}},
    {"L", true, 1.0, -3, {3, 0, 0, 0, 0, 0}},
    {"l", true, 1.0, -3, {3, 0, 0, 0, 0, 0}},
    {"M", true, 1.0, 3, {-3, 0, 0, 0, 0, 1}},    // mol/L
    {"P", true, 1.0, -1, {-1, 1, -1, 0, 0, 0}},  // poise
    {"bar", true, 1.0, 5, {-1, 1, -2, 0, 0, 0}},
    {"dyn", true, 1.0, -5, {1, 1, -2, 0, 0, 0}},
    {"erg", true, 1.0, -7, {2, 1, -2, 0, 0, 0}},
    {"eV", true, 1.602176634, -19, {2, 1, -2, 0, 0, 0}},
    {"atm", false, 1.01325, 5, {-1, 1, -2, 0, 0, 0}},
    {"min", false, 6.0, 1, {0, 0, 1, 0, 0, 0}},
    {"h", false, 3.6, 3, {0, 0, 1, 0, 0, 0}},
    {"\xC3\x85", false, 1.0, -10, {1, 0, 0, 0, 0, 0}},      // angstrom, A with ring
    {"\xE2\x84\xAB", false, 1.0, -10, {1, 0, 0, 0, 0, 0}},  // angstrom sign
}};

struct Prefix {
  std::string_view name;
  int exponent10;
};

constexpr std::array<Prefix, 17> kPrefixes{{
    {"a", -18},
    {"f", -15},
    {"p", -12},
    {"n", -9},
    {"u", -6},
    {"\xC2\xB5", -6},  // micro sign
    {"\xCE\xBC", -6},  // Greek mu
    {"m", -3},
    {"c", -2},
    {"d", -1},
    {"h", 2},
    {"k", 3},
    {"M", 6},
    {"G", 9},
    {"T", 12},
    {"z", -21},
    {"y", -24},
}};

struct Name {
  std::array<int, 6> power;
  std::string_view name;
};

constexpr std::array<Name, 19> kNames{{
    {{0, 0, 0, 0, 0, 0}, "a pure number"},
    {{1, 0, 0, 0, 0, 0}, "length"},
    {{2, 0, 0, 0, 0, 0}, "area"},
    {{3, 0, 0, 0, 0, 0}, "volume"},
    {{0, 1, 0, 0, 0, 0}, "mass"},
    {{0, 0, 1, 0, 0, 0}, "time"},
    {{0, 0, -1, 0, 0, 0}, "rate"},
    {{0, 0, 0, 0, 1, 0}, "temperature"},
    {{1, 0, -1, 0, 0, 0}, "velocity"},
    {{1, 0, -2, 0, 0, 0}, "acceleration"},
    {{1, 1, -2, 0, 0, 0}, "force"},
    {{2, 1, -2, 0, 0, 0}, "energy or torque"},
    {{-1, 1, -2, 0, 0, 0}, "pressure"},
    {{-1, 1, -1, 0, 0, 0}, "dynamic viscosity"},
    {{2, 0, -1, 0, 0, 0}, "kinematic viscosity"},
    {{-3, 1, 0, 0, 0, 0}, "density"},
    {{-2, 1, -2, 0, 0, 0}, "force per volume"},
    {{-3, 0, 0, 0, 0, 1}, "concentration"},
    {{2, 1, -3, -1, 0, 0}, "voltage"},
}};

std::optional<Unit> find_plain(std::string_view symbol, int prefix10, bool prefixed) {
  for (const Symbol& known : kSymbols) {
    if (known.name == symbol && (known.takes_prefix || !prefixed)) {
      return Unit{known.factor, known.exponent10 + prefix10, 0, {known.power}};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view symbol) {
  if (symbol == "kT") {
    return Unit{1.0, 0, 1, {{2, 1, -2, 0, 0, 0}}};
  }
  // A symbol of its own goes before one with a prefix: "min" is no milli-inch, and "Pa"
  // no peta-year.
  if (const auto unit = find_plain(symbol, 0, false)) {
    return unit;
  }
  for (const Prefix& prefix : kPrefixes) {
    if (symbol.size() > prefix.name.size() &&
        symbol.substr(0, prefix.name.size()) == prefix.name) {
      if (const auto unit =
              find_plain(symbol.substr(prefix.name.size()), prefix.exponent10, true)) {
        return unit;
      }
    }
  }
  return std::nullopt;
}

std::string name_of(const Dimension& dimension) {
  constexpr std::array<const char*, 6> kBase{"m", "kg", "s", "A", "K", "mol"};
  for (const Name& known : kNames) {
    if (known.power == dimension.power) {
      return std::string(known.name);
    }
  }
  std::string out;
  for (std::size_t i = 0; i < kBase.size(); ++i) {
    const int power = dimension.power[i];
    if (power != 0) {
      out += out.empty() ? "" : " ";
      out += power == 1 ? kBase[i] : fmt::format("{}^{}", kBase[i], power);
    }
  }
  return out;
}

}  // namespace colloid
