#include "scene/json_text.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"

namespace colloid {

namespace {

constexpr std::size_t kDeepestNesting = 32;  // a scene has 6

/// An input iterator that tells how far the parser has read.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

/// Follows the parser through the text with the JSON pointer of where it is.  The virtual
/// functions see every member at its key and every element at its value.
class PointerTracker : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit PointerTracker(const std::string& text) : text_(text) {}

  void parse() {
    const char* begin = text_.data();
    nlohmann::json::sax_parse(CountingIterator(begin, &consumed_),
                              CountingIterator(begin + text_.size(), &consumed_), this);
  }

  bool null() override { return scalar(); }
  bool boolean(bool) override { return scalar(); }
  bool number_integer(number_integer_t) override { return number(); }
  bool number_unsigned(number_unsigned_t) override { return number(); }
  bool number_float(number_float_t, const string_t&) override { return number(); }
  bool string(string_t&) override { return scalar(); }
  bool binary(binary_t&) override { return scalar(); }
  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = name;
    const bool go_on = on_member(name, token_begin());
    last_end_ = consumed_;
    return go_on;
  }

 protected:
  virtual bool on_member(const std::string& name, std::size_t offset) = 0;
  virtual bool on_element(std::size_t offset) = 0;
  virtual bool on_open(std::size_t depth, std::size_t offset) = 0;

  /// The first character of the token the parser has just read.
  std::size_t token_begin() const {
    const std::size_t at = text_.find_first_not_of(" \t\r\n,:", last_end_);
    return at == std::string::npos ? text_.size() : at;
  }

  std::string pointer() const {
    std::string out;
    for (const Level& level : levels_) {
      out = join_pointer(out, level.is_array ? std::to_string(level.index) : level.key);
    }
    return out;
  }

  /// Makes `pointer` that of the value that begins; whether it is an element of an array.
  bool begin_value() {
    const bool is_element = !levels_.empty() && levels_.back().is_array;
    if (is_element) {
      ++levels_.back().index;
    }
    return is_element;
  }

  const std::string& text() const { return text_; }
  std::size_t depth() const { return levels_.size(); }

 private:
  struct Level {
    bool is_array = false;
    std::string key;
    std::size_t index = std::numeric_limits<std::size_t>::max();  // before the first
  };

  bool value() { return begin_value() ? on_element(token_begin()) : true; }

  bool scalar() {
    const bool go_on = value();
    last_end_ = consumed_;
    return go_on;
  }

  /// The parser sees that a number has ended only from the character after it.
  bool number() {
    const std::size_t begin = token_begin();
    const bool go_on = value();
    last_end_ = text_.find_first_not_of("+-.0123456789eE", begin);
    last_end_ = std::min(last_end_, text_.size());
    return go_on;
  }

  bool open(bool is_array) {
    const bool go_on = value() && on_open(levels_.size() + 1, token_begin());
    last_end_ = consumed_;
    levels_.push_back({is_array, {}});
    return go_on;
  }

  bool close() {
    levels_.pop_back();
    last_end_ = consumed_;
    return true;
  }

  const std::string& text_;
  std::size_t consumed_ = 0;
  std::size_t last_end_ = 0;
  std::vector<Level> levels_;
};

/// Why people's JSON is not JSON, where the parser's own words would not tell.
std::string known_mistake(const std::string& text, std::size_t offset) {
  const std::string_view here = std::string_view(text).substr(offset);
  const auto begins = [&](std::string_view word) {
    return here.substr(0, word.size()) == word;
  };
  for (const char* word :
       {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "+Infinity"}) {
    if (begins(word)) {
      return fmt::format(
          "{} is not a JSON number, and no quantity may be infinite or "
          "undefined",
          word);
    }
  }
  if (begins("//") || begins("/*") || begins("#")) {
    return "JSON has no comments (the key \"description\" takes one)";
  }
  if (begins("'")) {
    return "JSON strings are in double quotes";
  }
  for (const char* word : {"True", "False", "None"}) {
    if (begins(word)) {
      return fmt::format("{} is Python; JSON has true, false and null", word);
    }
  }
  const std::size_t before =
      text.find_last_not_of(" \t\r\n", offset == 0 ? 0 : offset - 1);
  if ((begins("}") || begins("]")) && before != std::string::npos &&
      text[before] == ',') {
    return "a comma before a closing bracket";
  }
  return offset >= text.size() ? "the text ends in the middle of a value" : "";
}

class StrictChecker : public PointerTracker {
 public:
  StrictChecker(const std::string& text, const std::string& path)
      : PointerTracker(text), path_(path) {}

  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::json::exception& error) override {
    const std::size_t offset = token_begin();
    if (error.id == 406) {  // number overflow
      begin_value();
      refuse(offset, pointer() + ": the number is beyond the range of a double");
    }
    std::string why = known_mistake(text(), offset);
    if (why.empty()) {
      why = error.what();
      const std::size_t dash = why.find(" - ");
      why = why.substr(dash == std::string::npos ? 0 : dash + 3, 160);
    }
    refuse(offset, "is not JSON: " + why);
  }

 protected:
  bool on_member(const std::string& name, std::size_t offset) override {
    const auto [first, is_new] = seen_[depth()].emplace(name, offset);
    if (!is_new) {
      refuse(offset, fmt::format("{}: the key is given twice, first on line {}",
                                 pointer(), position_of(text(), first->second).line));
    }
    return true;
  }
  bool on_element(std::size_t) override { return true; }
  bool on_open(std::size_t depth, std::size_t offset) override {
    if (depth > kDeepestNesting) {
      refuse(offset, fmt::format("is nested more than {} levels deep", kDeepestNesting));
    }
    seen_[depth].clear();
    return true;
  }

 private:
  [[noreturn]] void refuse(std::size_t offset, const std::string& why) const {
    throw InputError(path_ + " " + to_string(position_of(text(), offset)), why);
  }

  const std::string& path_;
  /// By depth: the keys met so far in the object that is open there, and their offsets.
  std::map<std::size_t, std::map<std::string, std::size_t>> seen_;
};

class Locator : public PointerTracker {
 public:
  Locator(const std::string& text, const std::string& target)
      : PointerTracker(text), target_(target) {}

  std::size_t offset() const { return best_; }

  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::json::exception&) override {
    return false;  // only called for text that parse_json accepted
  }

 protected:
  bool on_member(const std::string&, std::size_t offset) override { return meet(offset); }
  bool on_element(std::size_t offset) override { return meet(offset); }
  bool on_open(std::size_t depth, std::size_t offset) override {
    if (depth == 1) {
      best_ = offset;
    }
    return true;
  }

 private:
  /// Keeps the deepest place on the way to the target; stops at the target.
  bool meet(std::size_t offset) {
    const std::string here = pointer();
    const bool on_the_way =
        target_.compare(0, here.size(), here) == 0 &&
        (target_.size() == here.size() || target_[here.size()] == '/');
    if (on_the_way) {
      best_ = offset;
    }
    return here != target_;
  }

  const std::string& target_;
  std::size_t best_ = 0;
};

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& path) {
  StrictChecker(text, path).parse();
  return nlohmann::json::parse(text);
}

TextPosition locate(const std::string& text, const std::string& pointer) {
  Locator locator(text, pointer);
  locator.parse();
  return position_of(text, locator.offset());
}

std::string join_pointer(const std::string& pointer, const std::string& key) {
  std::string out = pointer + "/";
  for (const char c : key) {
    out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return out;
}

}  // namespace colloid
