// A realisation as groups and attributes below one group, and back, bit for bit.
#pragma once

#include "io/hdf5.h"
#include "io/realisation.h"

namespace colloid {

/// The datasets are a function of the realisation alone, without times of day or seconds
/// of computing, so that two files of one realisation have the same datasets.
void write_realisation(const H5Handle& root, const Realisation& realisation);

Realisation read_realisation(const H5Handle& root);

}  // namespace colloid
