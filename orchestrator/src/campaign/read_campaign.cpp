#include "campaign/read_campaign.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/json_text.h"
#include "base/text.h"
#include "campaign/key_reader.h"
#include "campaign/target.h"

namespace colloid {

namespace {

using nlohmann::json;

const std::vector<std::string> kTiers{"auto", "one_way", "quasi_steady", "transient"};
const std::vector<std::string> kExecutors{"local", "slurm"};
constexpr int kMostRealisations = 10'000'000;
constexpr std::size_t kMostPoints = 10'000;

void read_limits(const json& value, Limits& limits) {
  KeyReader read(value, "/limits");
  read.integer("workers", 0, 4096, limits.workers);
  read.number("seconds_per_realisation", 0.001, 1e9, limits.seconds_per_realisation);
  read.number("seconds_to_stop", 0.0, 3600.0, limits.seconds_to_stop);
  read.integer("attempts", 1, 1000, limits.attempts);
  read.number("checkpoint_interval", 0.0, 1e9, limits.checkpoint_interval);
  read.finish();
}

/// Only the names are checked here: their meaning is the statistics' own.
void check_statistics(const json& value, int realisations) {
  KeyReader read(value, "/statistics");
  double confidence = 0.95;
  int bootstrap = 2000;
  read.number("confidence", 0.5, 0.9999, confidence);
  read.integer("bootstrap", 100, 1'000'000, bootstrap);
  if (const json* target = read.find("target")) {
    read_target(*target, realisations);
  }
  read.finish();
}

/// An unsigned integer of 64 bits, as text: doubles, and many readers of JSON, hold 53.
std::string seed_text(const json& value) {
  std::string text = value.is_string()            ? value.get<std::string>()
                     : value.is_number_unsigned() ? value.dump()
                                                  : "";
  const bool digits = !text.empty() && text.size() <= 20 &&
                      text.find_first_not_of("0123456789") == std::string::npos &&
                      (text == "0" || text[0] != '0');
  const bool fits = digits && (text.size() < 20 || text <= "18446744073709551615");
  require(fits, "/master_seed",
          fmt::format("is {}, expected an integer in [0, 18446744073709551615]",
                      shown(value)));
  return text;
}

void read_fidelity(const json& value, Campaign& campaign) {
  require(value.is_object(), "/fidelity",
          fmt::format("is {}, expected an object", shown(value)));
  campaign.fidelity = value;
  const auto tier = campaign.fidelity.find("tier");
  if (tier == campaign.fidelity.end()) {
    return;
  }
  const json given = tier->is_array() ? *tier : json::array({*tier});
  require(!given.empty(), "/fidelity/tier", "is an empty list, expected a tier");
  std::set<std::string> seen;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string where =
        tier->is_array() ? fmt::format("/fidelity/tier/{}", i) : "/fidelity/tier";
    require(given[i].is_string(), where,
            fmt::format("is {}, expected {}", shown(given[i]), alternatives(kTiers)));
    const auto word = given[i].get<std::string>();
    require(std::find(kTiers.begin(), kTiers.end(), word) != kTiers.end(), where,
            fmt::format("is {}, expected {}; the nearest is \"{}\"", in_quotes(word),
                        alternatives(kTiers), nearest(word, kTiers)));
    require(seen.insert(word).second, where, "is given twice");
    campaign.tiers.push_back(word);
  }
  campaign.fidelity.erase("tier");
}

void read_vary(const json& value, Campaign& campaign) {
  require(value.is_object(), "/vary",
          fmt::format("is {}, expected an object of JSON pointers with lists of values",
                      shown(value)));
  std::size_t points = 1;
  for (const auto& [pointer, values] : value.items()) {
    const std::string where = join_pointer("/vary", pointer);
    require(!pointer.empty() && pointer[0] == '/', where,
            "is not a JSON pointer into the scene, such as \"/colloids/diameter\"");
    require(pointer != "/fidelity/tier", where,
            "cannot be varied: tiers are compared at the same design point; give a list "
            "in /fidelity/tier");
    require(pointer != "/fidelity" && pointer != "/description", where,
            "cannot be varied; vary the keys below it");
    require(values.is_array() && !values.empty(), where,
            fmt::format("is {}, expected a list of values", shown(values)));
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        require(values[i] != values[j], fmt::format("{}/{}", where, i),
                "is given twice: two design points would be one");
      }
    }
    for (const auto& [other, ignored] : campaign.vary) {
      require(pointer.compare(0, other.size() + 1, other + "/") != 0 &&
                  other.compare(0, pointer.size() + 1, pointer + "/") != 0,
              where, fmt::format("lies within {}, which is varied too", other));
    }
    points *= values.size();
    require(points <= kMostPoints, "/vary",
            fmt::format("gives more than {} design points", kMostPoints));
    campaign.vary[pointer] = values.get<std::vector<json>>();
  }
}

void read_scene(const json& value, Campaign& campaign) {
  require(value.is_object() || value.is_string(), "/scene",
          fmt::format("is {}, expected a scene or the name of its file", shown(value)));
  if (value.is_object()) {
    campaign.scene = value;
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(campaign.path).parent_path();
  const std::string file =
      (folder / value.get<std::string>()).lexically_normal().string();
  require(is_file(file), "/scene", fmt::format("there is no file {}", in_quotes(file)));
  campaign.scene_path = file;
  campaign.scene = parse_json(read_text_file(file), file);
}

void read_keys(const json& root, Campaign& campaign) {
  KeyReader read(root, "");
  campaign.name = "";
  read.get("campaign");
  read.text("campaign", campaign.name);
  require(is_campaign_name(campaign.name), "/campaign",
          fmt::format("is {}, expected 1 to 64 letters, digits or ._- that begin with a "
                      "letter or digit (it names a folder)",
                      in_quotes(campaign.name)));
  read.text("description", campaign.description);
  const json& scene = read.get("scene");
  read.get("realisations");
  read.integer("realisations", 1, kMostRealisations, campaign.realisations);
  campaign.master_seed = seed_text(read.get("master_seed"));
  read.flag("independent_points", campaign.independent_points);
  if (const json* fidelity = read.find("fidelity")) {
    read_fidelity(*fidelity, campaign);
  }
  if (const json* vary = read.find("vary")) {
    read_vary(*vary, campaign);
  }
  read.word("executor", kExecutors, campaign.executor);
  read.integer("ranks", 1, 4096, campaign.ranks);
  if (const json* limits = read.find("limits")) {
    read_limits(*limits, campaign.limits);
  }
  if (const json* slurm = read.find("slurm")) {
    campaign.slurm = read_slurm_options(*slurm, "/slurm");
  }
  campaign.statistics = json::object();
  if (const json* statistics = read.find("statistics")) {
    check_statistics(*statistics, campaign.realisations);
    campaign.statistics = *statistics;
  }
  read.finish();
  read_scene(scene, campaign);
}

}  // namespace

bool is_campaign_name(const std::string& name) {
  const auto is_letter_or_digit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  return !name.empty() && name.size() <= 64 && is_letter_or_digit(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return is_letter_or_digit(c) || c == '.' || c == '_' || c == '-';
         });
}

void refuse(const Campaign& campaign, const std::string& pointer,
            const std::string& why) {
  throw InputError(campaign.path + " " + locate(campaign.text, pointer),
                   pointer + ": " + why);
}

Campaign parse_campaign(const std::string& text, const std::string& path) {
  Campaign campaign;
  campaign.path = path;
  campaign.text = text;
  const json root = parse_json(text, path);
  try {
    read_keys(root, campaign);
  } catch (const InputError& error) {
    if (error.where().empty() || error.where()[0] != '/' ||
        error.where().find(' ') != std::string::npos) {
      throw;  // it names a file already
    }
    refuse(campaign, error.where(), error.why());
  }
  return campaign;
}

Campaign read_campaign(const std::string& path) {
  return parse_campaign(read_text_file(path), path);
}

}  // namespace colloid
