#include "scene/field_reader.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/error.h"
#include "core/quantity.h"
#include "core/text.h"
#include "scene/field_lister.h"
#include "scene/json_text.h"

namespace colloid {

namespace {

using nlohmann::json;

/// A value as a message shows it.
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

/// The key the user may have meant: one of that name in another section, or the nearest.
std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  for (const FieldRow& row : list_fields()) {
    if (row.pointer.substr(row.pointer.rfind('/') + 1) == name) {
      return fmt::format("did you mean {}?", row.pointer);
    }
  }
  return fmt::format("the nearest is {}", in_quotes(nearest(name, known)));
}

}  // namespace

FieldReader::FieldReader(const json& root) {
  require(root.is_object(), "/", fmt::format("is {}, expected an object", shown(root)));
  levels_.push_back({&root, "", {}, {}, {}});
}

void FieldReader::quantity(const Key& key, const Measure& measure, double& value) {
  if (const json* found = find(key)) {
    value = read_quantity(*found, measure, pointer_to(key));
  }
}

void FieldReader::quantity_or(const Key& key, const char* word, const Measure& measure,
                              std::optional<double>& value) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  const bool is_word =
      *word != '\0' && found->is_string() && found->get_ref<const std::string&>() == word;
  value = is_word ? std::nullopt
                  : std::optional(read_quantity(*found, measure, pointer_to(key), word));
}

void FieldReader::quantity_per_pair(const Key& key, const Measure& measure,
                                    const std::vector<PairValue>& pairs) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  if (!found->is_object()) {
    const double common = read_quantity(*found, measure, pointer_to(key));
    for (const PairValue& pair : pairs) {
      *pair.value = common;
    }
    return;
  }
  levels_.push_back({found, pointer_to(key), {}, {}, {}});
  for (const PairValue& pair : pairs) {
    quantity(required({pair.name, ""}), measure, *pair.value);
  }
  leave();
}

void FieldReader::vector(const Key& key, const Measure& measure, Vec3& value) {
  if (const json* found = find(key)) {
    value = read_vector(*found, measure, pointer_to(key));
  }
}

void FieldReader::vector(const Key& key, const Measure& measure,
                         std::optional<Vec3>& value) {
  const json* found = find(key);
  if (found != nullptr && !(key.nullable && found->is_null())) {
    value = read_vector(*found, measure, pointer_to(key));
  }
}

void FieldReader::number(const Key& key, const Range& range, double& value) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  require(found->is_number(), pointer_to(key),
          fmt::format("is {}, expected a number in {}", shown(*found), range.text()));
  value = found->get<double>();
  require(range.contains(value), pointer_to(key),
          fmt::format("is {}, must be in {}", found->dump(), range.text()));
}

void FieldReader::integer(const Key& key, const Range& range, int& value) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  require(found->is_number_integer(), pointer_to(key),
          fmt::format("is {}, expected an integer in {}", shown(*found), range.text()));
  // As a double first: an integer of 64 bits need not fit an int.
  require(range.contains(found->get<double>()), pointer_to(key),
          fmt::format("is {}, must be in {}", found->dump(), range.text()));
  value = found->get<int>();
}

void FieldReader::flag(const Key& key, bool& value) {
  if (const json* found = find(key)) {
    require(found->is_boolean(), pointer_to(key),
            fmt::format("is {}, expected true or false", shown(*found)));
    value = found->get<bool>();
  }
}

void FieldReader::text(const Key& key, std::string& value) {
  if (const json* found = find(key)) {
    require(found->is_string(), pointer_to(key),
            fmt::format("is {}, expected a text in double quotes", shown(*found)));
    value = found->get<std::string>();
  }
}

void FieldReader::exactly_one(const std::vector<std::string>& names) {
  levels_.back().one_of = names;
}

void FieldReader::word(const Key& key, const std::vector<std::string>& words,
                       int& index) {
  const json* found = find(key);
  if (found == nullptr) {
    return;
  }
  require(found->is_string(), pointer_to(key),
          fmt::format("is {}, expected {}", shown(*found), alternatives(words)));
  const auto& given = found->get_ref<const std::string&>();
  const auto match = std::find(words.begin(), words.end(), given);
  require(match != words.end(), pointer_to(key),
          fmt::format("is {}, expected {}; the nearest is \"{}\"", in_quotes(given),
                      alternatives(words), nearest(given, words)));
  index = static_cast<int>(match - words.begin());
}

bool FieldReader::enter(const Key& key, bool) {
  const json* found = find(key);
  if (found == nullptr) {
    return false;
  }
  require(found->is_object(), pointer_to(key),
          fmt::format("is {}, expected an object ({})", shown(*found), key.doc));
  levels_.push_back({found, pointer_to(key), {}, {}, {}});
  return true;
}

bool FieldReader::enter_list(const Key& key, std::size_t& count) {
  const json* found = find(key);
  if (found == nullptr) {
    return false;
  }
  require(found->is_array(), pointer_to(key),
          fmt::format("is {}, expected a list ({})", shown(*found), key.doc));
  count = found->size();
  levels_.push_back({found, pointer_to(key), {}, {}, {}});
  return true;
}

void FieldReader::enter_item(std::size_t index) {
  const json& item = (*levels_.back().value)[index];
  const std::string where = join_pointer(levels_.back().pointer, std::to_string(index));
  require(item.is_object(), where, fmt::format("is {}, expected an object", shown(item)));
  levels_.push_back({&item, where, {}, {}, {}});
}

void FieldReader::leave() {
  const Level level = levels_.back();
  levels_.pop_back();
  if (!level.value->is_object()) {
    return;
  }
  // Unknown before missing: a misspelt key is both, and the misspelling is the news.
  refuse_unknown_keys(level);
  if (!level.missing.empty()) {
    throw InputError(level.pointer.empty() ? "/" : level.pointer,
                     fmt::format("has no key {}, which is required",
                                 in_quotes(level.missing.front())));
  }
  if (level.one_of.empty()) {
    return;
  }
  std::vector<std::string> given;
  std::copy_if(level.one_of.begin(), level.one_of.end(), std::back_inserter(given),
               [&](const std::string& name) { return level.value->contains(name); });
  require(given.size() == 1, level.pointer,
          fmt::format("has {} of these keys{}{}, expected exactly one: {}", given.size(),
                      given.empty() ? "" : " at once: ", fmt::join(given, ", "),
                      alternatives(level.one_of)));
}

const json* FieldReader::find(const Key& key) {
  Level& level = levels_.back();
  level.known.emplace_back(key.name);
  const auto found = level.value->find(key.name);
  if (found == level.value->end()) {
    if (key.required && key.applies) {
      level.missing.emplace_back(key.name);
    }
    return nullptr;
  }
  if (!key.applies) {
    throw InputError(pointer_to(key),
                     fmt::format("can only be given with {}", key.only_with));
  }
  return &*found;
}

std::string FieldReader::pointer_to(const Key& key) const {
  return join_pointer(levels_.back().pointer, key.name);
}

double FieldReader::read_quantity(const json& value, const Measure& measure,
                                  const std::string& where, const char* word) const {
  require(value.is_string(), where, [&] {
    return fmt::format(
        "is {}, expected a text with a number and a unit, such as \"{}\"{}", shown(value),
        example_quantity(measure.unit),
        *word == '\0' ? "" : fmt::format(", or \"{}\"", word));
  });
  const auto& given = value.get_ref<const std::string&>();
  // Without a digit it is a misspelt word rather than a bad quantity.
  const bool is_other_word =
      *word != '\0' && given.find_first_of("0123456789") == std::string::npos;
  require(!is_other_word, where, [&] {
    return fmt::format(
        "is {}, expected \"{}\" or a quantity such as \"{}\"; the nearest is \"{}\"",
        in_quotes(given), word, example_quantity(measure.unit), word);
  });
  const double si = parse_quantity(given, measure.unit, temperature_, where);
  require(measure.range.contains(si), where, [&] {
    return fmt::format("is {}, must be in {} {}", in_quotes(given), measure.range.text(),
                       measure.unit);
  });
  return si;
}

Vec3 FieldReader::read_vector(const json& value, const Measure& measure,
                              const std::string& where) const {
  require(value.is_array() && value.size() == 3, where, [&] {
    return fmt::format(
        "is {}, expected a list of 3 quantities (x, y, z), each such as \"{}\"",
        shown(value), example_quantity(measure.unit));
  });
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    out[axis] = read_quantity(value[i], measure, join_pointer(where, std::to_string(i)));
  }
  return out;
}

void FieldReader::refuse_unknown_keys(const Level& level) {
  for (const auto& member : level.value->items()) {
    const std::string& name = member.key();
    if (std::find(level.known.begin(), level.known.end(), name) == level.known.end()) {
      throw InputError(
          join_pointer(level.pointer, name),
          fmt::format("is not a known key here; {}; known: {}",
                      suggestion(name, level.known), fmt::join(level.known, ", ")));
    }
  }
}

}  // namespace colloid
