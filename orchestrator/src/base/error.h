// Errors by audience.  A user's mistake is an InputError; a disk, database or machine
// that does not do its part is a StorageError; a programmer's mistake is an assert.
// Thrown where found, caught once in main, which prints one line and returns the exit
// code.
#pragma once

#include <stdexcept>
#include <string>

namespace colloid {

/// A campaign, file or command line that is refused.
class InputError : public std::runtime_error {
 public:
  /// `where` is a JSON pointer, a file with its line, or an option.
  InputError(const std::string& where, const std::string& why)
      : std::runtime_error(where + ": " + why), where_(where), why_(why) {}

  const std::string& where() const { return where_; }
  const std::string& why() const { return why_; }

 private:
  std::string where_;
  std::string why_;
};

/// A file, folder or database that could not be written or read.  What is finished stays
/// on the disk; the campaign can be resumed.
class StorageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Always on: refuses the user's input unless `ok`.
inline void require(bool ok, const std::string& where, const std::string& why) {
  if (!ok) {
    throw InputError(where, why);
  }
}

}  // namespace colloid
