// Makes JSON of a scene: every key that applies, quantities in SI with all digits.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/fields.h"

namespace colloid {

class FieldWriter : public Fields {
 public:
  explicit FieldWriter(nlohmann::ordered_json& root) : levels_{&root} {}

  void quantity(const Key& key, const Measure& measure, double& value) override;
  void quantity_or(const Key& key, const char* word, const Measure& measure,
                   std::optional<double>& value) override;
  void quantity_per_pair(const Key& key, const Measure& measure,
                         const std::vector<PairValue>& pairs) override;
  void vector(const Key& key, const Measure& measure, Vec3& value) override;
  void vector(const Key& key, const Measure& measure,
              std::optional<Vec3>& value) override;
  void number(const Key& key, const Range& range, double& value) override;
  void integer(const Key& key, const Range& range, int& value) override;
  void flag(const Key& key, bool& value) override;
  void text(const Key& key, std::string& value) override;

 protected:
  void word(const Key& key, const std::vector<std::string>& words, int& index) override;
  bool enter(const Key& key, bool present) override;
  bool enter_list(const Key& key, std::size_t& count) override;
  void enter_item(std::size_t index) override;
  void leave() override { levels_.pop_back(); }

 private:
  void put(const Key& key, nlohmann::ordered_json value);

  std::vector<nlohmann::ordered_json*> levels_;
};

}  // namespace colloid
