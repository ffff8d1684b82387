// Errors of OpenFOAM as ours.
#pragma once

#include <functional>

namespace colloid {

/// Runs `work`; a FatalError in it becomes a std::runtime_error with its message, on one
/// line.  Numerics that fail are no such error: they have to be looked for.
void with_our_errors(const std::function<void()>& work);

}  // namespace colloid
