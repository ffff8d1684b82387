#include "core/quantity.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "core/text.h"
#include "core/units.h"

namespace colloid {

namespace {

constexpr int kLargestExponent = 1000000;  // of a number; far beyond double already

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A decimal number split so that a power of ten can be added before it is rounded.
struct Decimal {
  std::string mantissa;  ///< sign, digits and point
  int exponent10 = 0;
  std::size_t length = 0;  ///< characters of the text it took; 0: no number
};

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) {
    ++at;
  }
  return at;
}

Decimal split_decimal(std::string_view text) {
  const bool has_sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  const std::size_t begin = has_sign ? 1 : 0;
  std::size_t at = skip_digits(text, begin);
  std::size_t digits = at - begin;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = skip_digits(text, at + 1);
    digits += end - at - 1;
    at = end;
  }
  if (digits == 0) {
    return {};
  }
  Decimal decimal;
  // from_chars knows no leading "+"
  decimal.mantissa = text.substr(text[0] == '+' ? 1 : 0, at - (text[0] == '+' ? 1 : 0));
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const bool exponent_sign =
        at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+');
    const std::size_t first = at + (exponent_sign ? 2 : 1);
    const std::size_t end = skip_digits(text, first);
    if (end > first) {  // otherwise it is a unit, as in "5eV"
      int value = 0;
      for (std::size_t i = first; i < end; ++i) {
        value = std::min(10 * value + (text[i] - '0'), kLargestExponent);
      }
      decimal.exponent10 = text[at + 1] == '-' ? -value : value;
      at = end;
    }
  }
  decimal.length = at;
  return decimal;
}

/// The double nearest to mantissa * 10^exponent10; nothing if it is out of range.
std::optional<double> round_decimal(const Decimal& decimal, int exponent10) {
  const std::string text =
      fmt::format("{}e{}", decimal.mantissa, decimal.exponent10 + exponent10);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  assert(result.ptr == text.data() + text.size());
  if (result.ec != std::errc{} || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

double parse_quantity(std::string_view text, std::string_view si_unit, double temperature,
                      const std::string& where) {
  const Unit expected = parse_unit(si_unit, where, [] { return std::string(); });
  const auto wish = [&] {
    return fmt::format("; expected a number with a unit of {}, such as {}",
                       name_of(expected.dimension), in_quotes(example_quantity(si_unit)));
  };
  const std::string_view body = trimmed(text);
  const Decimal decimal = split_decimal(body);
  require(decimal.length > 0, where, [&] {
    return in_quotes(text) + " does not begin with a finite number" + wish();
  });
  const std::string_view unit_text = trimmed(body.substr(decimal.length));
  require(!unit_text.empty(), where,
          [&] { return in_quotes(text) + " has no unit" + wish(); });

  const Unit unit = parse_unit(unit_text, where, wish);
  require(unit.dimension == expected.dimension, where, [&] {
    return fmt::format("{} is of the wrong dimension ({}){}", in_quotes(text),
                       name_of(unit.dimension), wish());
  });
  const std::optional<double> value = round_decimal(decimal, unit.exponent10);
  const double thermal = std::pow(kBoltzmann * temperature, unit.thermal);
  require(value && std::isfinite(*value * unit.factor * thermal), where,
          [&] { return in_quotes(text) + " is beyond the range of a double"; });
  return *value * unit.factor * thermal;
}

std::string format_quantity(double value, std::string_view si_unit) {
  return fmt::format("{} {}", shortest(value), si_unit);
}

std::string example_quantity(std::string_view si_unit) {
  struct Example {
    std::string_view unit;
    std::string_view text;
  };
  constexpr std::array<Example, 15> kExamples{{
      {"m", "13.3 um"},
      {"s", "5 s"},
      {"K", "298 K"},
      {"V", "-27.9 mV"},
      {"Pa", "70 MPa"},
      {"Pa s", "1 mPa s"},
      {"kg/m^3", "1000 kg/m^3"},
      {"m/s", "0.5 mm/s"},
      {"m/s^2", "-9.81 m/s^2"},
      {"1/s", "100 1/s"},
      {"mol/m^3", "300 mM"},
      {"J", "1e-20 J"},
      {"N", "1 pN"},
      {"N m", "1e-18 N m"},
      {"N/m^3", "1 kPa/m"},
  }};
  for (const Example& known : kExamples) {
    if (known.unit == si_unit) {
      return std::string(known.text);
    }
  }
  return fmt::format("1 {}", si_unit);
}

}  // namespace colloid
