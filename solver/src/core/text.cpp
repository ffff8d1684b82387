#include "core/text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

namespace colloid {

namespace {

constexpr std::size_t kLongestEcho = 80;  // [byte] of the user's text in a message

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  std::size_t cut = std::min(text.size(), kLongestEcho);
  while (cut < text.size() && cut > 0 &&
         (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) {
    --cut;  // not inside a UTF-8 sequence
  }
  for (const char c : text.substr(0, cut)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20U || byte == 0x7FU) {
      out += fmt::format("\\u{:04x}", byte);
    } else {
      out += c;
    }
  }
  return out + (cut < text.size() ? "..." : "");
}

std::string in_quotes(std::string_view text) {
  return '"' + printable(text) + '"';
}

std::string alternatives(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) {
      out += i + 1 == words.size() ? " or " : ", ";
    }
    out += words[i];
  }
  return out;
}

int edit_distance(std::string_view a, std::string_view b) {
  // Optimal string alignment; three rows: two before, before, and this one.
  const std::size_t width = b.size() + 1;
  std::vector<int> older(width);
  std::vector<int> old(width);
  std::vector<int> row(width);
  for (std::size_t j = 0; j < width; ++j) {
    old[j] = static_cast<int>(j);
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < width; ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({old[j] + 1, row[j - 1] + 1, old[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
          lower(a[i - 2]) == lower(b[j - 1])) {
        row[j] = std::min(row[j], older[j - 2] + 1);
      }
    }
    std::swap(older, old);
    std::swap(old, row);
  }
  return old.back();
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  assert(!candidates.empty());
  // A key may be thousands of characters long; its beginning decides.
  const std::string_view head = word.substr(0, kLongestEcho);
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](const std::string& a, const std::string& b) {
                             return edit_distance(head, a) < edit_distance(head, b);
                           });
}

std::string shortest(double number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return {digits.data(), end.ptr};
}

}  // namespace colloid
