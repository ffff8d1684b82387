// JSON text: checked more strictly than the library does (a key given twice), and the
// place in the text of a JSON pointer, for messages.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace colloid {

/// The value in `text`.  Refuses what is not JSON and a key given twice in one object;
/// `path` names the file in the message.
nlohmann::json parse_json(const std::string& text, const std::string& path);

/// "line 3, column 7": where the member or element at `pointer` begins (a member at its
/// key), or the innermost value around it that exists.  `text` was accepted by
/// parse_json.
std::string locate(const std::string& text, const std::string& pointer);

/// `pointer` extended by a key, which is escaped (RFC 6901).
std::string join_pointer(const std::string& pointer, const std::string& key);

}  // namespace colloid
