// The scene's keys as the code declares them against schemas/scene.schema.json, in both
// directions, and scenes good and bad judged by both.
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "anomaly/bad_scenes.h"
#include "commands/describe.h"
#include "core/error.h"
#include "core/quantity.h"
#include "core/text_file.h"
#include "scene/read_scene.h"

namespace colloid {
namespace {

using nlohmann::json;

const std::string kSource = PORECLOG_SOURCE_DIR;

json schema_json() {
  return json::parse(read_text_file(kSource + "/schemas/scene.schema.json"));
}

/// The type of a schema's entry in the words of `describe`.
std::string type_of(const json& entry) {
  if (entry.contains("properties")) {
    return "section";
  }
  if (entry.contains("enum")) {
    return "choice";
  }
  if (entry.contains("x-unit")) {
    const std::string text = entry.dump();
    return text.find("\"minItems\":3") != std::string::npos ? "vector" : "quantity";
  }
  const std::string type = entry.value("type", "none");
  return type == "string" ? "text" : type == "array" ? "list" : type;
}

/// An entry in the words of `describe --json`; the alternatives of anyOf are the words,
/// the pairs and the null that may stand instead of a quantity.
json described(const std::string& pointer, const json& entry, bool required) {
  json row{{"pointer", pointer}, {"type", type_of(entry)}, {"doc", entry["description"]}};
  const std::pair<const char*, const char*> renamed[] = {
      {"x-unit", "unit"},
      {"minimum", "minimum"},
      {"x-minimum", "minimum"},
      {"exclusiveMinimum", "exclusive_minimum"},
      {"x-exclusive-minimum", "exclusive_minimum"},
      {"maximum", "maximum"},
      {"x-maximum", "maximum"},
      {"enum", "values"},
      {"default", "default"},
      {"x-if-absent", "if_absent"},
      {"x-only-with", "only_with"},
  };
  for (const auto& [theirs, ours] : renamed) {
    if (entry.contains(theirs)) {
      row[ours] = entry[theirs];
    }
  }
  row["required"] = required;
  row["nullable"] = false;
  for (const json& choice : entry.value("anyOf", json::array())) {
    if (choice.contains("enum")) {
      row["values"] = choice["enum"];
    } else if (choice.contains("required")) {
      row["per_pair"] = choice["required"];
      EXPECT_EQ(choice["properties"].size(), choice["required"].size()) << pointer;
    } else if (choice.value("type", "") == "null") {
      row["nullable"] = true;
    }
  }
  return row;
}

/// Adds the members of an object schema, with "*" for the index in lists.
void collect(const json& object, const std::string& prefix,
             std::map<std::string, json>& rows) {
  EXPECT_EQ(object.value("additionalProperties", true), false)
      << prefix << " lets unknown keys pass";
  const json required = object.value("required", json::array());
  for (const auto& [name, entry] : object["properties"].items()) {
    const std::string pointer = prefix + "/" + name;
    const bool must = std::find(required.begin(), required.end(), name) != required.end();
    rows[pointer] = described(pointer, entry, must);
    if (rows[pointer]["type"] == "section") {
      collect(entry, pointer, rows);
    } else if (rows[pointer]["type"] == "list") {
      collect(entry["items"], pointer + "/*", rows);
    }
  }
}

/// Defaults compare by value: the schema may say "96.6 um" where the code says 9.66e-05
/// m.
json in_si(json row) {
  if (!row.contains("unit") || !row.contains("default")) {
    return row;
  }
  const auto convert = [&](json& value) {
    if (value != "computed") {
      value = parse_quantity(value.get<std::string>(), row["unit"].get<std::string>(),
                             298.0, row["pointer"].get<std::string>());
    }
  };
  if (row["default"].is_array()) {
    for (json& component : row["default"]) {
      convert(component);
    }
  } else {
    convert(row["default"]);
  }
  return row;
}

TEST(SceneSchema, DeclaresTheKeysOfTheCodeAndNoOthers) {
  std::map<std::string, json> in_schema;
  collect(schema_json(), "", in_schema);
  std::map<std::string, json> in_code;
  const json keys = json::parse(scene_keys_json()["keys"].dump());
  for (const json& row : keys) {
    in_code[row["pointer"].get<std::string>()] = row;
  }
  EXPECT_GT(in_code.size(), 60U);
  for (const auto& [pointer, row] : in_code) {
    EXPECT_EQ(in_schema.count(pointer), 1U) << pointer << " is not in the schema";
  }
  for (auto& [pointer, row] : in_schema) {
    ASSERT_EQ(in_code.count(pointer), 1U) << pointer << " is not in the code";
    // box is required without a preset only, which the schema says with oneOf
    const bool conditional = pointer == "/geometry/box";
    row["required"] = conditional ? json(true) : row["required"];
    EXPECT_EQ(in_si(row), in_si(in_code[pointer])) << pointer;
  }
}

class Judge {
 public:
  Judge() {
    const json text = schema_json();
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
  }

  bool schema_accepts(const json& scene) const {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(scene),
                              nullptr);
  }

 private:
  valijson::Schema schema_;
};

bool code_accepts(const std::string& text) {
  try {
    parse_scene(text, "s.json");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(SceneSchema, AcceptsTheExamplesAndTheirSpeltOutForms) {
  const Judge judge;
  int examples = 0;
  for (const char* folder : {"/campaigns", "/campaigns/scenes"}) {
    for (const auto& file : std::filesystem::directory_iterator(kSource + folder)) {
      const std::string path = file.path().string();
      const std::string ending = ".scene.json";
      if (path.size() < ending.size() ||
          path.compare(path.size() - ending.size(), ending.size(), ending) != 0) {
        continue;
      }
      ++examples;
      EXPECT_TRUE(judge.schema_accepts(json::parse(read_text_file(path)))) << path;
      const std::string spelt_out = to_json(read_scene(path).scene).dump();
      EXPECT_TRUE(judge.schema_accepts(json::parse(spelt_out))) << path << spelt_out;
    }
  }
  EXPECT_GE(examples, 6);
}

TEST(SceneSchema, RefusesWhatTheCodeRefusesWhereItCan) {
  const Judge judge;
  for (const auto& scenes : {bad_keys_and_values(), bad_combinations()}) {
    for (const BadScene& scene : scenes) {
      EXPECT_FALSE(code_accepts(scene.text)) << scene.text;
      const json parsed = json::parse(scene.text, nullptr, false);
      if (!parsed.is_discarded()) {  // a number beyond double is no JSON for the library
        EXPECT_EQ(judge.schema_accepts(parsed), !scene.schema_knows) << scene.text;
      }
    }
  }
}

// Texts of quantities: the pattern in the schema may let more pass than the code, never
// less, or an editor would mark a good scene as bad.
TEST(SceneSchema, AcceptsEveryFormOfAQuantityThatTheCodeAccepts) {
  const Judge judge;
  const char* const good[] = {"5 s",           "5s",        " +5.0e-3   ks ", ".5 min",
                              "5. h",          "5 1/Hz",    "5 1 / Hz",       "5 (s)",
                              "5e0 \xC2\xB5s", "5 Pa s/Pa", "5 m/(m/s)"};
  for (const char* text : good) {
    const json scene{{"geometry", {{"box", {"1 m", "1 m", "1 m"}}}}, {"duration", text}};
    EXPECT_TRUE(code_accepts(scene.dump())) << text;
    EXPECT_TRUE(judge.schema_accepts(scene)) << text;
  }
  for (const char* text : {"", "5", "s", "nan s", "5 /s", "- s", ". s"}) {
    const json scene{{"geometry", {{"box", {"1 m", "1 m", "1 m"}}}}, {"duration", text}};
    EXPECT_FALSE(code_accepts(scene.dump())) << text;
    EXPECT_FALSE(judge.schema_accepts(scene)) << text;
  }
}

}  // namespace
}  // namespace colloid
