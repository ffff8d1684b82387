#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "core/units.h"

namespace colloid {

namespace {

constexpr int kLargestPower = 9;  // of a unit; more is a typing error
constexpr int kDeepestParentheses = 8;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Characters that a unit symbol is made of: letters, and the bytes of UTF-8 sequences.
bool is_symbol(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         static_cast<unsigned char>(c) >= 0x80U;
}

/// Recursive descent over a unit expression.
class UnitParser {
 public:
  /// `wish` composes the end of every message.
  UnitParser(std::string_view text, const std::string& where,
             const std::function<std::string()>& wish)
      : text_(text), where_(where), wish_(wish) {}

  Unit parse() {
    const Unit unit = expression(0);
    if (at_ < text_.size()) {
      refuse(fmt::format("unexpected {}", in_quotes(text_.substr(at_, 1))));
    }
    return unit;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(
        where_, fmt::format("{} is not a unit: {}{}", in_quotes(text_), why, wish_()));
  }

  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') {
      ++at_;
    }
  }

  bool take(char c) {
    skip_spaces();
    if (at_ < text_.size() && text_[at_] == c) {
      ++at_;
      return true;
    }
    return false;
  }

  /// factor { ("*" | "." | " " | "/") factor }
  Unit expression(int depth) {
    Unit unit = factor(depth);
    bool divided = false;
    for (skip_spaces(); at_ < text_.size() && text_[at_] != ')'; skip_spaces()) {
      if (take('/')) {
        multiply(unit, factor(depth), -1);
        divided = true;
        continue;
      }
      if (divided) {
        refuse("a product after \"/\" needs parentheses, as in \"J/(kg K)\"");
      }
      if (!take('*')) {
        take('.');
      }
      multiply(unit, factor(depth), 1);
    }
    return unit;
  }

  /// ( symbol | "1" | "(" expression ")" ) [ ["^"] integer ]
  Unit factor(int depth) {
    skip_spaces();
    if (at_ == text_.size()) {
      refuse("a symbol is missing at the end");
    }
    Unit base;
    if (take('(')) {
      if (depth == kDeepestParentheses) {
        refuse("too many parentheses");
      }
      base = expression(depth + 1);
      if (!take(')')) {
        refuse("a \")\" is missing");
      }
    } else if (text_[at_] == '1') {
      ++at_;
      return base;
    } else {
      base = symbol();
    }
    Unit unit;
    multiply(unit, base, power());
    return unit;
  }

  Unit symbol() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_symbol(text_[at_])) {
      ++at_;
    }
    if (at_ == begin) {
      refuse(fmt::format("unexpected {}", in_quotes(text_.substr(at_, 1))));
    }
    const std::string_view name = text_.substr(begin, at_ - begin);
    const std::optional<Unit> unit = find_unit(name);
    if (!unit) {
      refuse(fmt::format("unknown symbol {}", in_quotes(name)));
    }
    return *unit;
  }

  /// The integer after a symbol: "^-1", "-1", "2", or none, which is 1.
  int power() {
    const bool caret = at_ < text_.size() && text_[at_] == '^';
    if (caret) {
      ++at_;
    }
    bool negative = false;
    if (at_ + 1 < text_.size() && (text_[at_] == '-' || text_[at_] == '+') &&
        is_digit(text_[at_ + 1])) {
      negative = text_[at_] == '-';
      ++at_;
    }
    if (at_ == text_.size() || !is_digit(text_[at_])) {
      if (caret) {
        refuse("an integer is missing after \"^\"");
      }
      return 1;
    }
    int value = 0;
    for (; at_ < text_.size() && is_digit(text_[at_]); ++at_) {
      value = 10 * value + (text_[at_] - '0');
      if (value > kLargestPower) {
        refuse(fmt::format("powers go up to {}", kLargestPower));
      }
    }
    return negative ? -value : value;
  }

  static void multiply(Unit& unit, const Unit& other, int power) {
    unit.factor *= std::pow(other.factor, power);
    unit.exponent10 += power * other.exponent10;
    unit.thermal += power * other.thermal;
    for (std::size_t i = 0; i < unit.dimension.power.size(); ++i) {
      unit.dimension.power[i] += power * other.dimension.power[i];
    }
  }

  std::string_view text_;
  const std::string& where_;
  const std::function<std::string()>& wish_;
  std::size_t at_ = 0;
};

}  // namespace

Unit parse_unit(std::string_view text, const std::string& where,
                const std::function<std::string()>& wish) {
  return UnitParser(text, where, wish).parse();
}

}  // namespace colloid
