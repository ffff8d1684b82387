// Errors by audience.  A user's mistake is an InputError, numerics that fail are a
// ConvergenceError, a disk that does not take a result is an OutputError, a programmer's
// mistake is an assert.  Thrown where found, caught once
// in main, which prints one line and returns the exit code named here.
#pragma once

#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace colloid {

/// A scene, file or command line that is refused.  Exit code 2.
class InputError : public std::runtime_error {
 public:
  /// `where` is a JSON pointer ("/fluid/viscosity"), a file or an option.
  InputError(const std::string& where, const std::string& why)
      : std::runtime_error(where + ": " + why), where_(where), why_(why) {}

  const std::string& where() const { return where_; }
  const std::string& why() const { return why_; }

 private:
  std::string where_;
  std::string why_;
};

/// A computation that did not converge or became unstable.  Exit code 3.
class ConvergenceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that could not be written: full disk, quota, broken device.  Exit code 4.
class OutputError : public std::runtime_error {
 public:
  /// `error_number`: errno of the system call that failed.
  OutputError(const std::string& path, const std::string& what, int error_number)
      : std::runtime_error(path + ": " + what + ": " +
                           std::generic_category().message(error_number)) {}
};

/// Always on: refuses the user's input unless `ok`.
inline void require(bool ok, const std::string& where, const std::string& why) {
  if (!ok) {
    throw InputError(where, why);
  }
}

/// The same where it is called often: `why` is a function that composes the message.
template <class Why, class = decltype(std::string(std::declval<Why>()()))>
void require(bool ok, const std::string& where, Why&& why) {
  if (!ok) {
    throw InputError(where, why());
  }
}

}  // namespace colloid
