// Fills a scene from JSON and refuses whatever is not understood.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/fields.h"

namespace colloid {

/// Throws InputError whose `where` is the JSON pointer.  A key that is left out keeps the
/// struct's default; a key that no declaration asked for is an error when its section
/// ends.
class FieldReader : public Fields {
 public:
  explicit FieldReader(const nlohmann::json& root);

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
  void exactly_one(const std::vector<std::string>& names) override;
  void temperature(double kelvin) override { temperature_ = kelvin; }

  /// Ends the outermost section; to be called after declare().
  void finish() { leave(); }

 protected:
  void word(const Key& key, const std::vector<std::string>& words, int& index) override;
  bool enter(const Key& key, bool present) override;
  bool enter_list(const Key& key, std::size_t& count) override;
  void enter_item(std::size_t index) override;
  void leave() override;

 private:
  /// An object, or an array, that is being read.
  struct Level {
    const nlohmann::json* value;
    std::string pointer;
    std::vector<std::string> known;    ///< keys that were declared
    std::vector<std::string> missing;  ///< required keys that are not there
    std::vector<std::string> one_of;   ///< keys of which exactly one must be there
  };

  /// The value of a key, or null if it is left out.
  const nlohmann::json* find(const Key& key);
  std::string pointer_to(const Key& key) const;
  double read_quantity(const nlohmann::json& value, const Measure& measure,
                       const std::string& where, const char* word = "") const;
  Vec3 read_vector(const nlohmann::json& value, const Measure& measure,
                   const std::string& where) const;
  static void refuse_unknown_keys(const Level& level);

  std::vector<Level> levels_;
  double temperature_ = 0.0;  // [K]
};

}  // namespace colloid
