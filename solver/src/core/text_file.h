// Whole text files in memory, refused early and with a reason if they cannot be text.
#pragma once

#include <string>
#include <string_view>

namespace colloid {

/// Line and column in a text, both from 1; columns count characters, not bytes.
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
};

TextPosition position_of(std::string_view text, std::size_t offset);

/// "line 3, column 14"
std::string to_string(const TextPosition& position);

/// The content of a UTF-8 file without its byte order mark.  Refuses what is missing, a
/// folder, unreadable, empty, larger than 256 MiB or not UTF-8.
std::string read_text_file(const std::string& path);

}  // namespace colloid
