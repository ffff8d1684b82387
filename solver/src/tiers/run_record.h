// What every time loop records of its state, and asks before a colloid enters.
#pragma once

#include "particles/surfaces.h"
#include "tiers/run_state.h"

namespace colloid {

/// `permeability` now and of the clean pore [m^2]; `first_injected`: id of the first
/// colloid that is injected.
SeriesRow make_series_row(const RunState& state, double critical_diameter,
                          double permeability, double first_permeability,
                          int first_injected);

/// Retained colloids, then mobile ones.
Frame make_frame(const RunState& state, double radius);

Counts final_counts(const SeriesRow& last);

/// Whether no mobile or retained colloid has its centre within `distance` of `position`
/// [m].
bool has_room(const RunState& state, const FixedSurfaces& surfaces, const Vec3& position,
              double distance);

}  // namespace colloid
