// Reads the keys of one JSON object: each once, with its type and range; a key nobody
// asked for is an error, never ignored.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace colloid {

class KeyReader {
 public:
  /// `pointer` is that of `object` in its file.  InputError if it is not an object.
  KeyReader(const nlohmann::json& object, std::string pointer);

  /// The value of a key, or null if it is left out.
  const nlohmann::json* find(const char* key);
  /// The same, refused if it is left out.
  const nlohmann::json& get(const char* key);

  // A key that is left out leaves `value` as it is.
  void text(const char* key, std::string& value);
  void flag(const char* key, bool& value);
  void integer(const char* key, int low, int high, int& value);
  void number(const char* key, double low, double high, double& value);
  void word(const char* key, const std::vector<std::string>& words, std::string& value);

  /// Refuses the first key that was not asked for.
  void finish() const;

  std::string pointer_to(const char* key) const;

 private:
  const nlohmann::json& object_;
  std::string pointer_;
  std::vector<std::string> known_;
};

/// A value as a message shows it.
std::string shown(const nlohmann::json& value);

}  // namespace colloid
