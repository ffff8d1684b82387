#include "campaign/key_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/json_text.h"
#include "base/text.h"

namespace colloid {

using nlohmann::json;

std::string shown(const json& value) {
  if (value.is_object()) {
    return "an object";
  }
  if (value.is_array()) {
    return fmt::format("a list of {}", value.size());
  }
  if (value.is_string()) {
    return "the text " + in_quotes(value.get_ref<const std::string&>());
  }
  return value.is_number() ? "the number " + value.dump() : value.dump();
}

KeyReader::KeyReader(const json& object, std::string pointer)
    : object_(object), pointer_(std::move(pointer)) {
  require(object_.is_object(), pointer_.empty() ? "/" : pointer_,
          fmt::format("is {}, expected an object", shown(object_)));
}

const json* KeyReader::find(const char* key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
    known_.emplace_back(key);
  }
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

const json& KeyReader::get(const char* key) {
  const json* found = find(key);
  require(found != nullptr, pointer_.empty() ? "/" : pointer_,
          fmt::format("has no key \"{}\", which is required", key));
  return *found;
}

void KeyReader::text(const char* key, std::string& value) {
  if (const json* found = find(key)) {
    require(found->is_string(), pointer_to(key),
            fmt::format("is {}, expected a text in double quotes", shown(*found)));
    value = found->get<std::string>();
  }
}

void KeyReader::flag(const char* key, bool& value) {
  if (const json* found = find(key)) {
    require(found->is_boolean(), pointer_to(key),
            fmt::format("is {}, expected true or false", shown(*found)));
    value = found->get<bool>();
  }
}

void KeyReader::integer(const char* key, int low, int high, int& value) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  // As a double: an integer of 64 bits need not fit an int.
  require(
      found->is_number_integer() && found->get<double>() >= low &&
          found->get<double>() <= high,
      pointer_to(key),
      fmt::format("is {}, expected an integer in [{}, {}]", shown(*found), low, high));
  value = found->get<int>();
}

void KeyReader::number(const char* key, double low, double high, double& value) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  require(
      found->is_number() && found->get<double>() >= low && found->get<double>() <= high,
      pointer_to(key),
      fmt::format("is {}, expected a number in [{}, {}]", shown(*found), low, high));
  value = found->get<double>();
}

void KeyReader::word(const char* key, const std::vector<std::string>& words,
                     std::string& value) {
  std::string given = value;
  text(key, given);
  require(std::find(words.begin(), words.end(), given) != words.end(), pointer_to(key),
          fmt::format("is {}, expected {}; the nearest is \"{}\"", in_quotes(given),
                      alternatives(words), nearest(given, words)));
  value = given;
}

void KeyReader::finish() const {
  for (const auto& member : object_.items()) {
    const bool known =
        std::find(known_.begin(), known_.end(), member.key()) != known_.end();
    require(known, join_pointer(pointer_, member.key()),
            known
                ? ""
                : fmt::format("is not a known key here; the nearest is \"{}\"; known: {}",
                              nearest(member.key(), known_), fmt::join(known_, ", ")));
  }
}

std::string KeyReader::pointer_to(const char* key) const {
  return join_pointer(pointer_, key);
}

}  // namespace colloid
