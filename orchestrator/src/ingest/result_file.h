// Reads result.h5, the file a solver leaves of one realisation (schemas/result.md).
#pragma once

#include <stdexcept>
#include <string>

#include "store/records.h"

namespace colloid {

/// A file that is not whole, or not laid out as a result.
class TornResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws TornResult with what is wrong.
ResultRecord read_result(const std::string& path);

}  // namespace colloid
