#include "store/records.h"

#include <algorithm>
#include <array>

namespace colloid {

namespace {

struct CauseRow {
  const char* name;
  bool counts;  ///< uses up an attempt
  bool retry;   ///< may end differently
};

// In the order of the enumeration.  A solve that does not converge and a scene that is
// refused do so again: the solver is deterministic.
constexpr std::array<CauseRow, 15> kCauses{{
    {"running", false, false},
    {"finished", false, false},
    {"refused", true, false},
    {"not_converged", true, false},
    {"internal_error", true, true},
    {"crashed", true, true},
    {"killed", true, true},
    {"out_of_memory", true, true},
    {"time_limit", true, true},
    {"interrupted", false, true},
    {"no_result", true, true},
    {"torn_result", true, true},
    {"foreign_result", true, true},
    {"not_started", true, true},
    {"lost", false, true},
}};

}  // namespace

const char* name_of(Cause cause) {
  return kCauses.at(static_cast<std::size_t>(cause)).name;
}

Cause cause_named(const std::string& name) {
  const auto* const row = std::find_if(kCauses.begin(), kCauses.end(),
                                       [&](const CauseRow& r) { return name == r.name; });
  return row == kCauses.end() ? Cause::lost : static_cast<Cause>(row - kCauses.begin());
}

bool counts_as_failure(Cause cause) {
  return kCauses.at(static_cast<std::size_t>(cause)).counts;
}

bool is_worth_retrying(Cause cause) {
  return kCauses.at(static_cast<std::size_t>(cause)).retry;
}

}  // namespace colloid
