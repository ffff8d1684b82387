// What is kept of a whole ensemble so that questions need not read all its realisations:
// mean curves, and counts of retained colloids.
#pragma once

#include "store/database.h"

namespace colloid {

/// Writes the table `curve` of an ensemble anew: mean and standard deviation of critical
/// diameter and permeability ratio over its ingested realisations, at the output times of
/// the first of them.  Realisations are added in the order of their indices, so that the
/// result does not depend on the order in which they finished.  Within a transaction.
void write_curve(Database& database, std::int64_t ensemble);

/// Writes the table `layer_count` of an ensemble anew.  Within a transaction.
void write_layer_counts(Database& database, std::int64_t ensemble);

}  // namespace colloid
