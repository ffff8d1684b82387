// Times to clogging from elsewhere: a table with the columns
//
//     idx,t1_s,tc_s,censored,alpha_deg
//
// with a header line, in any order; idx, t1_s and alpha_deg may be missing.  censored is
// 1 or 0; tc_s of a censored row is the time until which it had not clogged.  An empty
// field, NA or NaN is no value.
#pragma once

#include <string>
#include <vector>

#include "statistics/outcome.h"

namespace colloid {

/// `path` names the file in messages.  InputError with line and column.
std::vector<statistics::RealisationOutcome> read_sample(const std::string& text,
                                                        const std::string& path);

}  // namespace colloid
