// The regime of a scene as JSON, shared by `measure` and `describe --regime`, and as a
// table.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tiers/regime.h"

namespace colloid {

/// The object "regime" of the interface; null where a number does not exist, as those of
/// the colloids in a scene without colloids.
nlohmann::ordered_json regime_json(const Regime& regime);

/// The same for people: numbers with their units, models with their reasons.
std::string regime_table(const Regime& regime);

/// A number, or null if it is not finite: JSON has no NaN.
nlohmann::ordered_json number_or_null(double value);

}  // namespace colloid
