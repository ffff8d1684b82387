// Two colloids that meet head-on without liquid: is the sub-step short enough?
#pragma once

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem/dem_case.h"
#include "tiers/transient/dem.h"

namespace colloid {

enum class ImpactOutcome { bounded, warned, unstable, refused };

/// bounded: they part with no more than the speed they met with; warned: the same, after
/// a warning; unstable: faster, or not at all; refused: the step is beyond its limit.
inline ImpactOutcome impact(double modulus, double step) {
  constexpr double kSpeed = 5e-3;  // each [m/s]: twice that in the throat
  DemOptions options = dem_test::inert();
  options.colloid.young_modulus = modulus;
  options.restitution = 0.9;
  options.step = step;
  try {
    Dem dem(options, {});
    const Vec3 apart{dem_test::kRadius + 5e-8, 0.0, 0.0};
    dem.add({0, dem_test::kMiddle - apart, {kSpeed, 0.0, 0.0}, {}});
    dem.add({1, dem_test::kMiddle + apart, {-kSpeed, 0.0, 0.0}, {}});
    // Hertz's duration, at most 20 us at 0.7 MPa, and the way there, 10 us.
    dem.advance(2e-4, {});
    const double out = -dem.states().at(0).velocity.x / kSpeed;
    if (!(out > 0.0 && out <= 1.0)) {
      return ImpactOutcome::unstable;
    }
    return dem.warnings().empty() ? ImpactOutcome::bounded : ImpactOutcome::warned;
  } catch (const InputError&) {
    return ImpactOutcome::refused;
  } catch (const ConvergenceError&) {
    return ImpactOutcome::unstable;
  }
}

}  // namespace colloid
