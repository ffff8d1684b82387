// `poreclog-solve describe`: the keys of a scene, with units, ranges and defaults; the
// regime of one scene; the colloids that enter it.
#pragma once

#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "commands/command.h"

namespace colloid {

/// {"schema_version": 1, "keys": [{"pointer", "type", "unit", ...}]}
nlohmann::ordered_json scene_keys_json();

/// The same for people: a table of 4 columns.
std::string scene_keys_table();

std::unique_ptr<Command> make_describe();

}  // namespace colloid
