// The seed of a realisation.
//
// A pure function of the campaign's master seed and the realisation's index, so that more
// realisations, other workers, another tier or a restart change no seed, and so that
// every design point meets the same injections (common random numbers make paired
// differences sharp).  master + index would do the first, but the ensembles of
// neighbouring master seeds would overlap; a hash does not.
#pragma once

#include <cstdint>
#include <string>

namespace colloid {

/// The first 8 bytes, big-endian, of SHA-256 of the text
///
///     poreclog seed 1\n<master seed>\n<index>\n
///
/// with both numbers in decimal, followed by `point_hash` and \n if that is not empty.
/// `point_hash` is the content hash of the design point when the campaign asks for
/// independent points: never its number, which depends on the order of values.
std::uint64_t realisation_seed(const std::string& master_seed, int index,
                               const std::string& point_hash);

}  // namespace colloid
