#include "commands/describe.h"

#include <algorithm>
#include <iostream>
#include <optional>

#include <fmt/format.h>

#include "commands/injection_list.h"
#include "commands/regime_json.h"
#include "commands/scene_regime.h"
#include "core/error.h"
#include "core/random.h"
#include "core/text.h"
#include "scene/field_lister.h"
#include "scene/names.h"
#include "scene/read_scene.h"

namespace colloid {

namespace {

constexpr int kSchemaVersion = 1;

/// What may stand for the key: unit, range, words.
std::string allowed(const FieldRow& row) {
  std::string out = row.unit;
  if (row.range) {
    out += (out.empty() ? "" : " ") + row.range->text();
  }
  if (!row.words.empty()) {
    out += (out.empty() ? "" : ", or ") + fmt::format("{}", fmt::join(row.words, " | "));
  }
  if (!row.pairs.empty()) {
    out += fmt::format(", or per pair {{{}}}", fmt::join(row.pairs, ", "));
  }
  if (row.nullable) {
    out += ", or null";
  }
  return out.empty() ? row.type : out;
}

/// What holds if the key is left out.
std::string without_key(const FieldRow& row) {
  if (row.required) {
    return "required";
  }
  if (!row.if_absent.empty()) {
    return "default: " + row.if_absent;
  }
  if (row.standard.is_null()) {
    return "no default";
  }
  if (row.standard.is_array()) {
    return fmt::format("default: {}",
                       fmt::join(row.standard.get<std::vector<std::string>>(), ", "));
  }
  return "default: " + (row.type == "text" || !row.standard.is_string()
                            ? row.standard.dump()
                            : row.standard.get<std::string>());
}

nlohmann::ordered_json row_json(const FieldRow& row) {
  nlohmann::ordered_json out{{"pointer", row.pointer}, {"type", row.type}};
  if (!row.unit.empty()) {
    out["unit"] = row.unit;
  }
  if (row.range) {
    out[row.range->above_low ? "exclusive_minimum" : "minimum"] = row.range->low;
    out["maximum"] = row.range->high;
  }
  if (!row.words.empty()) {
    out["values"] = row.words;
  }
  if (!row.pairs.empty()) {
    out["per_pair"] = row.pairs;
  }
  if (!row.standard.is_null()) {
    out["default"] = row.standard;
  }
  if (!row.if_absent.empty()) {
    out["if_absent"] = row.if_absent;
  }
  if (!row.only_with.empty()) {
    out["only_with"] = row.only_with;
  }
  out["required"] = row.required;
  out["nullable"] = row.nullable;
  out["doc"] = row.doc;
  return out;
}

nlohmann::ordered_json tier_json(const TierAdvice& tier) {
  return {{"name", word_of(tier.choice)},
          {"program", program_of(tier.choice)},
          {"reason", tier.reason}};
}

nlohmann::ordered_json cost_json(const TransientCost& cost) {
  return {{"cells", number_or_null(cost.cells)},
          {"steps", number_or_null(cost.steps)},
          {"seconds", number_or_null(cost.seconds)}};
}

std::string tier_table(const SceneRegime& found) {
  return fmt::format("\ntier {} ({}), by {}\n{}", word_of(found.tier.choice),
                     found.tier.reason, program_of(found.tier.choice),
                     found.cost ? cost_text(*found.cost) + " for a run\n" : "");
}

class Describe : public Command {
 public:
  void declare_options(CLI::App& app) override {
    app.add_flag("--json", json_, "One JSON object instead of a table");
    auto* what = app.add_option_group("what", "At most one:");
    what->add_option("--scene", scene_,
                     "Print this scene with every default spelled out, as JSON");
    what->add_option("--regime", regime_,
                     "Print the dimensionless numbers of this scene, and the models they "
                     "call for");
    what->add_option("--injections", injections_,
                     "Print the colloids that enter this scene within its duration");
    what->require_option(0, 1);
    app.add_option("--seed", seed_, "Of the injections: 0 to 2^64 - 1");
  }

  int run() const override {
    require(injections_ || !seed_, "--seed", "goes with --injections SCENE only");
    if (injections_) {
      require(seed_.has_value(), "--seed", "is missing: --injections needs one");
      print_injections(parse_seed(*seed_, "--seed"));
    } else if (regime_) {
      const SceneRegime found = scene_regime(*regime_);
      nlohmann::ordered_json regime = regime_json(found.regime);
      regime["tier"] = tier_json(found.tier);
      regime["cost"] = found.cost ? cost_json(*found.cost) : nullptr;
      const nlohmann::ordered_json document{{"schema_version", kSchemaVersion},
                                            {"regime", regime}};
      std::cout << (json_ ? document.dump(2) + "\n"
                          : regime_table(found.regime) + tier_table(found));
    } else if (scene_) {
      std::cout << to_json(read_scene(*scene_).scene).dump(2) << '\n';
    } else if (json_) {
      std::cout << scene_keys_json().dump(2) << '\n';
    } else {
      std::cout << scene_keys_table();
    }
    return exit_finished;
  }

 private:
  void print_injections(std::uint64_t seed) const {
    const InjectionList list = list_injections(*injections_, seed);
    nlohmann::ordered_json document{{"schema_version", kSchemaVersion}};
    document.update(injections_json(list));
    std::cout << (json_ ? document.dump(2) + "\n" : injections_table(list));
  }

  bool json_ = false;
  std::optional<std::string> scene_;
  std::optional<std::string> regime_;
  std::optional<std::string> injections_;
  std::optional<std::string> seed_;
};

}  // namespace

nlohmann::ordered_json scene_keys_json() {
  nlohmann::ordered_json keys = nlohmann::ordered_json::array();
  for (const FieldRow& row : list_fields()) {
    keys.push_back(row_json(row));
  }
  return {{"schema_version", kSchemaVersion}, {"keys", keys}};
}

std::string scene_keys_table() {
  const std::vector<FieldRow> rows = list_fields();
  std::size_t width = 0;
  for (const FieldRow& row : rows) {
    width = std::max(width, row.pointer.size());
  }
  std::string out =
      "Keys of a scene.  Quantities are texts with a unit (\"13.3 um\"), vectors are "
      "lists "
      "of three; ranges and defaults are in SI.\n\n";
  for (const FieldRow& row : rows) {
    const std::string only =
        row.only_with.empty() ? "" : fmt::format(" (only with {})", row.only_with);
    out += fmt::format("{:<{}}  {}{}\n", row.pointer, width, row.doc, only);
    if (row.type != "section" && row.type != "list") {
      out += fmt::format("{:<{}}    {}; {}\n", "", width, allowed(row), without_key(row));
    }
  }
  return out;
}

std::unique_ptr<Command> make_describe() {
  return std::make_unique<Describe>();
}

}  // namespace colloid
