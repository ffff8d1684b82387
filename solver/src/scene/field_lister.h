// The list of all keys of a scene, for `describe`, the schema's test and suggestions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/fields.h"

namespace colloid {

/// One key.  Elements of lists have "*" for their index in the pointer.
// The library's json checks itself when moved, which clang-tidy takes for a throw.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct FieldRow {
  std::string pointer;
  std::string type;  ///< quantity, vector, number, integer, boolean, text, choice, ...
  std::string unit;  ///< SI; empty if there is none
  std::optional<Range> range;
  std::vector<std::string> words;   ///< of a choice, or a word instead of a quantity
  std::vector<std::string> pairs;   ///< keys of the object a quantity per pair may be
  nlohmann::ordered_json standard;  ///< the default as JSON; null if there is none
  bool required = false;
  bool nullable = false;
  std::string only_with;
  std::string if_absent;
  std::string doc;
};

std::vector<FieldRow> list_fields();

}  // namespace colloid
