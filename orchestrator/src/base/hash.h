// Names for content: equal hashes, equal content.
#pragma once

#include <string>
#include <string_view>

namespace colloid {

/// SHA-256 of `bytes` (FIPS 180-4), 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace colloid
