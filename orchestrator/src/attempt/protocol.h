// What an executor and poreclog-attempt say to each other.
//
// `poreclog-attempt --serve` keeps one attempt after another.  An attempt comes on
// kAttempts as the length of what follows (std::uint32_t) and words that end with a zero
// byte each: folder, seconds, seconds to stop, command line, then the command.  How it
// ended goes to kEndings as std::int32_t.  At the end of kAttempts the program ends.
#pragma once

#include <array>
#include <csignal>

namespace colloid {

/// What asks a keeper to stop, blocked from its first instruction: it waits for them.
constexpr std::array<int, 4> kStopSignals{SIGTERM, SIGINT, SIGQUIT, SIGHUP};

constexpr int kAttempts = 3;  ///< descriptor
constexpr int kEndings = 4;   ///< descriptor

// Endings: 0 if the attempt was kept, to whatever end.
constexpr int kNotKept = 1;          ///< it could not be begun or not be recorded
constexpr int kFolderNotMade = 100;  ///< plus errno: nothing has begun

}  // namespace colloid
