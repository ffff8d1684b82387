// The unit symbols that quantities may use.
#pragma once

#include <optional>
#include <string_view>

#include "core/quantity.h"

namespace colloid {

/// The unit of a symbol with or without a prefix ("um", "min", "kT"), if there is one.
std::optional<Unit> find_unit(std::string_view symbol);

/// What a dimension is called ("length"), or its SI base units ("kg m^2").
std::string name_of(const Dimension& dimension);

}  // namespace colloid
