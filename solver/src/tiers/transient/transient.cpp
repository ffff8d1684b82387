#include "tiers/transient/transient.h"

#include "core/error.h"

namespace colloid {

std::optional<Realisation> run_transient(const Scene& /*scene*/,
                                         const RunOptions& /*options*/) {
  throw ConvergenceError("the time loop of the tier transient is not there yet");
}

}  // namespace colloid
