// What is known of attempts that run elsewhere, where their locks need not be seen.
#pragma once

#include <optional>
#include <string>

namespace colloid {

enum class Presence {
  not_mine,  ///< another is to be asked: it was not begun through this
  active,    ///< it runs, or waits for its turn
  unknown,   ///< nobody answered
  ended      ///< it will not run any more, and its folder says how it ended
};

class AttemptWatch {
 public:
  AttemptWatch() = default;
  AttemptWatch(const AttemptWatch&) = delete;
  AttemptWatch& operator=(const AttemptWatch&) = delete;
  virtual ~AttemptWatch() = default;

  /// The number of the attempt for which this realisation waits, if it certainly has not
  /// begun: then its folder need not be looked at, of which there may be 100,000.
  virtual std::optional<int> waiting(const std::string& realisation_folder) = 0;

  /// Where the attempt is.
  virtual Presence presence(const std::string& attempt_folder) const = 0;

  /// The same; one that has ended without saying so gets an ending, after which nothing
  /// can begin it any more.
  virtual Presence conclude(const std::string& attempt_folder) = 0;
};

}  // namespace colloid
