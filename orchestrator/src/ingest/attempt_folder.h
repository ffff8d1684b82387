// Reads what an attempt left in its folder.
#pragma once

#include <optional>
#include <string>

#include "campaign/attempt_watch.h"
#include "store/records.h"

namespace colloid {

/// The attempt as its keeper and the solver recorded it; the cause is that of an attempt
/// without a result.  `command`: read from the folder if empty.
AttemptRecord read_attempt(const std::string& folder, int number,
                           const std::string& command = "");

/// The last line the solver wrote to stderr.
std::string last_message(const std::string& folder);

/// Was it begun by a keeper on another machine, whose locks may not be seen here?
bool on_another_machine(const std::string& folder);

/// Where an attempt is, as far as its folder and locks on this machine tell.
Presence presence_here(const std::string& folder);

/// Takes an attempt that has left no ending for lost, so that it cannot begin any more;
/// false if it is running after all.
bool give_up(const std::string& folder);

}  // namespace colloid
