#include "base/json_text.h"

#include <algorithm>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"

namespace colloid {

namespace {

constexpr int kDeepestNesting = 64;  // a campaign with its scene has 8

std::string place(const std::string& text, std::size_t offset) {
  const std::string before = text.substr(0, std::min(offset, text.size()));
  const std::size_t newline = before.rfind('\n');
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  const auto column = std::count_if(
      before.begin() + static_cast<std::ptrdiff_t>(begin), before.end(),
      [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return fmt::format("line {}, column {}",
                     std::count(before.begin(), before.end(), '\n') + 1, column + 1);
}

/// Walks through text that the library has accepted.  `visit(pointer, offset)` is called
/// at every member's key and every element.
class Walker {
 public:
  using Visit = std::function<void(const std::string&, std::size_t)>;
  using Repeated = std::function<void(const std::string&, std::size_t)>;

  Walker(const std::string& text, Visit visit, Repeated repeated)
      : text_(text), visit_(std::move(visit)), repeated_(std::move(repeated)) {}

  void walk() { value(""); }

 private:
  char peek() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  std::string string() {
    const std::size_t begin = at_++;
    while (text_[at_] != '"') {
      at_ += text_[at_] == '\\' ? 2 : 1;
    }
    ++at_;
    return nlohmann::json::parse(text_.substr(begin, at_ - begin)).get<std::string>();
  }

  void object(const std::string& pointer) {
    std::set<std::string> seen;
    for (++at_; peek() != '}';) {
      const std::size_t begin = at_;
      const std::string key = string();
      const std::string here = join_pointer(pointer, key);
      if (!seen.insert(key).second) {
        repeated_(here, begin);
      }
      visit_(here, begin);
      peek();  // the colon
      ++at_;
      value(here);
      at_ += peek() == ',' ? 1 : 0;
      peek();
    }
    ++at_;
  }

  void array(const std::string& pointer) {
    std::size_t index = 0;
    for (++at_; peek() != ']'; ++index) {
      const std::string here = pointer + "/" + std::to_string(index);
      visit_(here, at_);
      value(here);
      at_ += peek() == ',' ? 1 : 0;
    }
    ++at_;
  }

  void value(const std::string& pointer) {
    switch (peek()) {
      case '{':
        object(pointer);
        break;
      case '[':
        array(pointer);
        break;
      case '"':
        string();
        break;
      default:
        at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    }
  }

  const std::string& text_;
  Visit visit_;
  Repeated repeated_;
  std::size_t at_ = 0;
};

void refuse_deep_nesting(const std::string& text, const std::string& path) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      i += c == '\\' ? 1 : 0;
      in_string = c != '"';
    } else {
      in_string = c == '"';
      depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
      require(depth <= kDeepestNesting, path + " " + place(text, i),
              fmt::format("is nested more than {} levels deep", kDeepestNesting));
    }
  }
}

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& path) {
  refuse_deep_nesting(text, path);
  nlohmann::json parsed;
  try {
    parsed = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    std::string why = error.what();
    const std::size_t dash = why.find(" - ");
    why = why.substr(dash == std::string::npos ? 0 : dash + 3, 160);
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw InputError(path + " " + place(text, error.byte == 0 ? 0 : error.byte - 1),
                     "is not JSON: " + why);
  } catch (const nlohmann::json::exception&) {
    throw InputError(path, "is not JSON: a number is beyond the range of a double");
  }
  const auto repeated = [&](const std::string& pointer, std::size_t offset) {
    throw InputError(path + " " + place(text, offset),
                     pointer + ": the key is given twice");
  };
  Walker(
      text, [](const std::string&, std::size_t) {}, repeated)
      .walk();
  return parsed;
}

std::string locate(const std::string& text, const std::string& pointer) {
  std::size_t best = text.find_first_not_of(" \t\r\n");
  const auto meet = [&](const std::string& here, std::size_t offset) {
    const bool on_the_way =
        pointer.compare(0, here.size(), here) == 0 &&
        (pointer.size() == here.size() || pointer[here.size()] == '/');
    best = on_the_way ? offset : best;
  };
  Walker(text, meet, [](const std::string&, std::size_t) {}).walk();
  return place(text, best);
}

std::string join_pointer(const std::string& pointer, const std::string& key) {
  std::string out = pointer + "/";
  for (const char c : key) {
    out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return out;
}

}  // namespace colloid
