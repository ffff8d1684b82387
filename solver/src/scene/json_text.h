// JSON text: checked more strictly than the library does (duplicate keys, depth), and the
// place in the text of a JSON pointer, for messages.
//
// The place is found by parsing the text again when there is something to say about it,
// so that a scene of 100,000 spheres does not carry a table of a million places.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "core/text_file.h"

namespace colloid {

/// The value in `text`.  Refuses what is not JSON, a key given twice in one object, and
/// nesting that no scene has; `path` names the file in the message.
nlohmann::json parse_json(const std::string& text, const std::string& path);

/// Where the member or element at `pointer` begins (a member at its key); the innermost
/// enclosing value that exists if there is no such member.
TextPosition locate(const std::string& text, const std::string& pointer);

/// `pointer` extended by a key, which is escaped (RFC 6901).
std::string join_pointer(const std::string& pointer, const std::string& key);

}  // namespace colloid
