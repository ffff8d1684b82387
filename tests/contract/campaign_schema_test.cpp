// The campaign's keys as the code knows them against schemas/campaign.schema.json, in
// both directions, and campaigns judged by both.
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "base/error.h"
#include "base/files.h"
#include "campaign/read_campaign.h"

namespace colloid {
namespace {

using nlohmann::json;

json schema_json() {
  return json::parse(
      read_text_file(std::string(PORECLOG_SOURCE_DIR) + "/schemas/campaign.schema.json"));
}

json small_campaign() {
  return {{"campaign", "c"},
          {"scene", json::object()},
          {"realisations", 30},
          {"master_seed", 1}};
}

/// The refusal; empty if the code accepts it.
std::string refusal(const json& campaign) {
  try {
    parse_campaign(campaign.dump(), "c.json");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

bool schema_accepts(const json& campaign) {
  static const json text = schema_json();
  static valijson::Schema* const schema = [] {
    auto* const out = new valijson::Schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(text), *out);
    return out;
  }();
  return valijson::Validator().validate(
      *schema, valijson::adapters::NlohmannJsonAdapter(campaign), nullptr);
}

/// The keys that the code knows in a section: it lists them when it meets another.
std::set<std::string> known_to_code(const std::string& section) {
  json campaign = small_campaign();
  (section.empty() ? campaign : campaign[section])["no such key"] = 1;
  const std::string why = refusal(campaign);
  std::set<std::string> known;
  std::istringstream list(why.substr(why.find("known: ") + 7));
  for (std::string key; std::getline(list, key, ',');) {
    known.insert(key.substr(key.find_first_not_of(' ')));
  }
  return known;
}

TEST(CampaignSchema, HasTheKeysOfTheCodeAndNoOthers) {
  const json schema = schema_json();
  for (const std::string section : {"", "limits", "slurm", "statistics"}) {
    const json& object = section.empty() ? schema : schema["properties"][section];
    std::set<std::string> in_schema;
    for (const auto& [key, entry] : object["properties"].items()) {
      in_schema.insert(key);
      json campaign = small_campaign();
      (section.empty() ? campaign : campaign[section])[key] = entry["examples"][0];
      EXPECT_EQ(refusal(campaign), "") << key;
      EXPECT_TRUE(schema_accepts(campaign)) << key;
    }
    EXPECT_EQ(in_schema, known_to_code(section)) << section;
    EXPECT_EQ(object["additionalProperties"], false);
  }
}

TEST(CampaignSchema, JudgesAsTheCodeDoes) {
  const std::pair<const char*, json> cases[] = {
      {"campaign", "../x"},
      {"campaign", std::string(65, 'x')},
      {"campaign", 3},
      {"realisations", 0},
      {"realisations", 1.5},
      {"realisations", 100000000},
      {"master_seed", -1},
      {"master_seed", 1.5},
      {"master_seed", "01"},
      {"fidelity", {{"tier", "one"}}},
      {"fidelity", {{"tier", json::array()}}},
      {"fidelity", {{"tier", {"auto", "auto"}}}},
      {"vary", {{"a", {1}}}},
      {"vary", {{"/a", json::array()}}},
      {"vary", {{"/a", {1, 1}}}},
      {"vary", {{"/fidelity/tier", {"auto"}}}},
      {"vary", 3},
      {"executor", "slurm!"},
      {"ranks", 0},
      {"limits", {{"attempts", 0}}},
      {"limits", {{"workers", -1}}},
      {"limits", {{"seconds_per_realisation", 0}}},
      {"limits", {{"seconds_to_stop", "30 s"}}},
      {"slurm", {{"partition", "main; id"}}},
      {"slurm", {{"partition", "-p"}}},
      {"slurm", {{"partition", ""}}},
      {"slurm", {{"account", 3}}},
      {"slurm", {{"memory_MiB", -1}}},
      {"slurm", {{"realisations_per_task", 1.5}}},
      {"slurm", {{"launcher", "sh"}}},
      {"slurm", {{"options", "--qos=long"}}},
      {"slurm", {{"options", {"--wrap=id"}}}},
      {"slurm", {{"options", {"--qos=a b"}}}},
      {"slurm", {{"options", {"--qosx"}}}},
      {"slurm", {{"options", {"qos=long"}}}},
      {"slurm", {{"options", {"--comment=$(id)"}}}},
      {"slurm", {{"options", {3}}}},
      {"statistics", {{"confidence", 95}}},
      {"statistics", {{"bootstrap", 5}}},
      {"statistics", {{"target", 3}}},
      {"statistics", {{"target", {{"statistic", "t1"}}}}},
      {"statistics", {{"target", {{"half_width", 1.0}}}}},
      {"statistics", {{"target", {{"statistic", "t2"}, {"half_width", 1.0}}}}},
      {"statistics", {{"target", {{"statistic", "t1"}, {"half_width", 0}}}}},
      {"statistics", {{"target", {{"statistic", "t1"}, {"half_width", "0.1 s"}}}}},
      {"statistics",
       {{"target", {{"statistic", "t1"}, {"half_width", 1}, {"pilot", 19}}}}},
      {"statistics",
       {{"target", {{"statistic", "t1"}, {"half_width", 1}, {"batch", 0}}}}},
      {"statistics", {{"target", {{"statistic", "t1"}, {"half_width", 1}, {"most", 9}}}}},
      {"independent_points", 1},
      {"description", 1},
      {"scene", 1},
  };
  for (const auto& [key, value] : cases) {
    json campaign = small_campaign();
    campaign[key] = value;
    EXPECT_NE(refusal(campaign), "") << campaign;
    EXPECT_FALSE(schema_accepts(campaign)) << campaign;
  }
  for (const char* key : {"campaign", "scene", "realisations", "master_seed"}) {
    json campaign = small_campaign();
    campaign.erase(key);
    EXPECT_NE(refusal(campaign), "") << key;
    EXPECT_FALSE(schema_accepts(campaign)) << key;
  }
}

}  // namespace
}  // namespace colloid
