// The regime of a scene as JSON, shared by `measure` and `describe --regime`.
#pragma once

#include <nlohmann/json.hpp>

#include "tiers/regime.h"

namespace colloid {

/// The object "regime" of the interface; null where a number does not exist.
nlohmann::ordered_json regime_json(const Regime& regime);

/// A number, or null if it is not finite: JSON has no NaN.
nlohmann::ordered_json number_or_null(double value);

}  // namespace colloid
