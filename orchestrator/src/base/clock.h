// Two clocks: one for people, one for waiting.
#pragma once

#include <string>

namespace colloid {

/// Now, ISO 8601 in UTC with milliseconds.  For people: nothing is decided by it, so it
/// may be set back at any moment.
std::string utc_now();

/// Seconds since some moment, never set back: what durations are taken from.
double monotonic_seconds();

}  // namespace colloid
