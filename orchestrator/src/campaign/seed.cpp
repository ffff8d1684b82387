#include "campaign/seed.h"

#include <fmt/format.h>

#include "base/hash.h"

namespace colloid {

std::uint64_t realisation_seed(const std::string& master_seed, int index,
                               const std::string& point_hash) {
  std::string text = fmt::format("poreclog seed 1\n{}\n{}\n", master_seed, index);
  if (!point_hash.empty()) {
    text += point_hash + "\n";
  }
  return std::stoull(sha256(text).substr(0, 16), nullptr, 16);
}

}  // namespace colloid
