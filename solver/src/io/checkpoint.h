// A realisation interrupted: all that is needed to go on, bit for bit.
//
// The file is HDF5 with a user block of 512 bytes in front that states the format
// version, the size and the SHA-256 of what follows.  It is checked before the HDF5
// library sees anything, because a damaged file may crash that library rather than be
// refused.  Field by field checksums would leave HDF5's own structures unguarded.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/realisation.h"
#include "scene/scene.h"

namespace colloid {

/// What must be the same for a run to go on from a checkpoint.
struct RunIdentity {
  std::string scene_hash;
  std::uint64_t seed = 0;
  std::string tier;
  std::string version;  ///< of the program: another one may round differently
  std::string commit;
};

/// Of a run by this very program.
RunIdentity run_identity(const Scene& scene, std::uint64_t seed, const std::string& tier);

struct Checkpoint {
  RunIdentity identity;
  Realisation realisation;  ///< so far
  /// State of the tier by name ([a-z0-9_]+): fields, positions, random numbers' state.
  std::map<std::string, std::vector<double>> reals;
  std::map<std::string, std::vector<std::int64_t>> integers;
};

/// Replaces the file at `path`; at any moment there is the old one or the new one.
/// InputError, OutputError: as ResultFile.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// InputError if there is none at `path`, if a bit of it has changed, or if it is not one
/// of `expected`.
Checkpoint read_checkpoint(const std::string& path, const RunIdentity& expected);

}  // namespace colloid
