// Written by scripts/calibrate_lubrication.py from measured forces; not by hand.
#pragma once

namespace colloid {

/// By how much the grid takes a gap that closes for wider [cells]: for forces, for
/// torques, which it resolves better, and for the coupling of both, which it resolves
/// worse.
constexpr double kGapWidening = 0.23;
constexpr double kGapWideningTurning = 0.17;
constexpr double kGapWideningCoupling = 0.70;

/// Gap by which the widening falls to 1/e [cells]; the coupling has that of torques.
constexpr double kGapRange = 1.0;
constexpr double kGapRangeTurning = 0.18;

}  // namespace colloid
