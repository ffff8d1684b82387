#include "core/text_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "core/error.h"

namespace colloid {

namespace {

constexpr std::size_t kLargestFile = std::size_t{256} << 20U;  // [byte]

unsigned byte_at(std::string_view text, std::size_t offset) {
  return static_cast<unsigned char>(text[offset]);
}

/// Bytes of the UTF-8 sequence at `offset`; 0 if there is none (RFC 3629, table 3-7 of
/// the Unicode standard: no overlong forms, no surrogates, nothing beyond U+10FFFF).
std::size_t utf8_length(std::string_view text, std::size_t offset) {
  const unsigned lead = byte_at(text, offset);
  if (lead < 0x80U) {
    return 1;
  }
  const std::size_t length = lead < 0xC2U   ? 0
                             : lead < 0xE0U ? 2
                             : lead < 0xF0U ? 3
                             : lead < 0xF5U ? 4
                                            : 0;
  if (length == 0 || offset + length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, offset + i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  const unsigned second = byte_at(text, offset + 1);
  const bool overlong =
      (lead == 0xE0U && second < 0xA0U) || (lead == 0xF0U && second < 0x90U);
  const bool outside =
      (lead == 0xEDU && second > 0x9FU) || (lead == 0xF4U && second > 0x8FU);
  return overlong || outside ? 0 : length;
}

void require_utf8(std::string_view text, const std::string& path) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) {
      throw InputError(
          path + " " + to_string(position_of(text, at)),
          fmt::format("is not UTF-8 text (byte 0x{:02x})", byte_at(text, at)));
    }
    at += length;
  }
}

}  // namespace

TextPosition position_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t newline = before.rfind('\n');
  const std::string_view row =
      newline == std::string_view::npos ? before : before.substr(newline + 1);
  const auto is_character = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  };
  return {
      static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1,
      static_cast<std::size_t>(std::count_if(row.begin(), row.end(), is_character)) + 1};
}

std::string to_string(const TextPosition& position) {
  return fmt::format("line {}, column {}", position.line, position.column);
}

std::string read_text_file(const std::string& path) {
  require(!std::filesystem::is_directory(path), path, "is a folder, expected a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  require(file.is_open(), path,
          fmt::format("cannot be opened: {}", std::strerror(errno)));
  std::string text;
  std::array<char, 65536> chunk{};
  while (file.read(chunk.data(), chunk.size()) || file.gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
    require(text.size() <= kLargestFile, path,
            fmt::format("is larger than {} MiB", kLargestFile >> 20U));
  }
  require(!file.bad(), path, "cannot be read");
  require_utf8(text, path);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) {
    text.erase(0, kByteOrderMark.size());
  }
  require(text.find_first_not_of(" \t\r\n") != std::string::npos, path, "is empty");
  return text;
}

}  // namespace colloid
