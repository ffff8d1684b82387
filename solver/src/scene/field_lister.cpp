#include "scene/field_lister.h"

#include <utility>

#include "core/quantity.h"
#include "scene/json_text.h"

namespace colloid {

namespace {

class FieldLister : public Fields {
 public:
  std::vector<FieldRow> take() { return std::move(rows_); }

  void quantity(const Key& key, const Measure& measure, double& value) override {
    FieldRow& row = add(key, "quantity", measure);
    if (!key.required) {
      row.standard = format_quantity(value, measure.unit);
    }
  }

  void quantity_or(const Key& key, const char* word, const Measure& measure,
                   std::optional<double>&) override {
    FieldRow& row = add(key, "quantity", measure);
    if (*word != '\0') {
      row.words = {word};
      row.standard = word;
    }
  }

  void quantity_per_pair(const Key& key, const Measure& measure,
                         const std::vector<PairValue>& pairs) override {
    FieldRow& row = add(key, "quantity", measure);
    row.standard = format_quantity(*pairs.front().value, measure.unit);
    for (const PairValue& pair : pairs) {
      row.pairs.emplace_back(pair.name);
    }
  }

  void vector(const Key& key, const Measure& measure, Vec3& value) override {
    FieldRow& row = add(key, "vector", measure);
    if (!key.required) {
      for (int axis = 0; axis < 3; ++axis) {
        row.standard.push_back(format_quantity(value[axis], measure.unit));
      }
    }
  }

  void vector(const Key& key, const Measure& measure, std::optional<Vec3>&) override {
    add(key, "vector", measure);
  }

  void number(const Key& key, const Range& range, double& value) override {
    FieldRow& row = add(key, "number");
    row.range = range;
    row.standard = value;
  }

  void integer(const Key& key, const Range& range, int& value) override {
    FieldRow& row = add(key, "integer");
    row.range = range;
    row.standard = value;
  }

  void flag(const Key& key, bool& value) override {
    add(key, "boolean").standard = value;
  }

  void text(const Key& key, std::string& value) override {
    add(key, "text").standard = value;
  }

 protected:
  void word(const Key& key, const std::vector<std::string>& words, int& index) override {
    FieldRow& row = add(key, "choice");
    row.words = words;
    row.standard = words[static_cast<std::size_t>(index)];
  }

  bool enter(const Key& key, bool) override {
    prefixes_.push_back(add(key, "section").pointer);
    return true;
  }

  bool enter_list(const Key& key, std::size_t& count) override {
    prefixes_.push_back(add(key, "list").pointer);
    count = 1;  // one element stands for all
    return true;
  }

  void enter_item(std::size_t) override {
    prefixes_.push_back(join_pointer(prefixes_.back(), "*"));
  }

  void leave() override { prefixes_.pop_back(); }

 private:
  FieldRow& add(const Key& key, const char* type) {
    FieldRow row;
    row.pointer = join_pointer(prefixes_.empty() ? "" : prefixes_.back(), key.name);
    row.type = type;
    row.required = key.required;
    row.nullable = key.nullable;
    row.only_with = key.only_with;
    row.if_absent = key.if_absent;
    row.doc = key.doc;
    rows_.push_back(std::move(row));
    return rows_.back();
  }

  FieldRow& add(const Key& key, const char* type, const Measure& measure) {
    FieldRow& row = add(key, type);
    row.unit = measure.unit;
    row.range = measure.range;
    return row;
  }

  std::vector<FieldRow> rows_;
  std::vector<std::string> prefixes_;
};

}  // namespace

std::vector<FieldRow> list_fields() {
  FieldLister lister;
  Scene defaults;
  declare(lister, defaults);
  return lister.take();
}

}  // namespace colloid
