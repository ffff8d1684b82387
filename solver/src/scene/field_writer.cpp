#include "scene/field_writer.h"

#include <utility>

#include "core/quantity.h"

namespace colloid {

namespace {

using nlohmann::ordered_json;

ordered_json vector_json(const Vec3& value, const char* unit) {
  return {format_quantity(value.x, unit), format_quantity(value.y, unit),
          format_quantity(value.z, unit)};
}

}  // namespace

void FieldWriter::quantity(const Key& key, const Measure& measure, double& value) {
  put(key, format_quantity(value, measure.unit));
}

void FieldWriter::quantity_or(const Key& key, const char* word, const Measure& measure,
                              std::optional<double>& value) {
  if (value) {
    put(key, format_quantity(*value, measure.unit));
  } else if (*word != '\0') {
    put(key, word);
  }
}

void FieldWriter::quantity_per_pair(const Key& key, const Measure& measure,
                                    const std::vector<PairValue>& pairs) {
  ordered_json object;
  for (const PairValue& pair : pairs) {
    object[pair.name] = format_quantity(*pair.value, measure.unit);
  }
  put(key, std::move(object));
}

void FieldWriter::vector(const Key& key, const Measure& measure, Vec3& value) {
  put(key, vector_json(value, measure.unit));
}

void FieldWriter::vector(const Key& key, const Measure& measure,
                         std::optional<Vec3>& value) {
  if (value) {
    put(key, vector_json(*value, measure.unit));
  } else if (key.nullable) {
    put(key, nullptr);
  }
}

void FieldWriter::number(const Key& key, const Range&, double& value) {
  put(key, value);
}

void FieldWriter::integer(const Key& key, const Range&, int& value) {
  put(key, value);
}

void FieldWriter::flag(const Key& key, bool& value) {
  put(key, value);
}

void FieldWriter::text(const Key& key, std::string& value) {
  put(key, value);
}

void FieldWriter::word(const Key& key, const std::vector<std::string>& words,
                       int& index) {
  put(key, words.at(static_cast<std::size_t>(index)));
}

bool FieldWriter::enter(const Key& key, bool present) {
  if (!present || !key.applies) {
    return false;
  }
  ordered_json& section = (*levels_.back())[key.name];
  section = ordered_json::object();
  levels_.push_back(&section);
  return true;
}

bool FieldWriter::enter_list(const Key& key, std::size_t&) {
  if (!key.applies) {
    return false;
  }
  ordered_json& list = (*levels_.back())[key.name];
  list = ordered_json::array();
  levels_.push_back(&list);
  return true;
}

void FieldWriter::enter_item(std::size_t) {
  levels_.back()->push_back(ordered_json::object());
  levels_.push_back(&levels_.back()->back());
}

void FieldWriter::put(const Key& key, ordered_json value) {
  if (key.applies) {
    (*levels_.back())[key.name] = std::move(value);
  }
}

}  // namespace colloid
