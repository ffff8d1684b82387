// A colloid by itself under the linearised load.
// Reference  m v' = F - drag (v - U): v = U + F/drag + (v_0 - U - F/drag) exp(-t/tau),
//            tau = m/drag = 10.3 us, and the same for the spin with 2/5 m a^2 / torsion.
// Tolerance  the integration is exact in v for this load: rounding over 1000 sub-steps,
//            1e-12.  The position is the sum of midpoint velocities: relative error
//            (step/tau)^2 / 24 = 1e-6 at 5e-8 s.
#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

TEST(DemDrag, RelaxesExponentially) {
  const double tau = kMass / kDrag;
  const Vec3 stream{1e-3, 0.0, -2e-3};
  for (const double step : {5e-8, 2.5e-8}) {
    DemOptions options = inert();
    options.step = step;
    Dem dem(options, {});
    dem.add({3, kMiddle, {0.0, 1e-3, 0.0}, {0.0, 0.0, 50.0}});
    DemLoad load = stokes_drag(3, stream);
    load.spin = {10.0, 0.0, 0.0};
    for (int i = 0; i < 4; ++i) {
      dem.advance(0.5 * tau, {load});
    }
    const double left = std::exp(-2.0);
    const DemState after = dem.states().at(0);
    EXPECT_NEAR(after.velocity.x, 1e-3 * (1.0 - left), 1e-12 * 1e-3);
    EXPECT_NEAR(after.velocity.y, 1e-3 * left, 1e-12 * 1e-3);
    EXPECT_NEAR(after.velocity.z, -2e-3 * (1.0 - left), 1e-12 * 2e-3);
    const double spun =
        std::exp(-2.0 * tau * kTorsion / (0.4 * kMass * kRadius * kRadius));
    EXPECT_NEAR(after.spin.z, 50.0 * spun, 1e-12 * 50.0);
    EXPECT_NEAR(after.spin.x, 10.0 * (1.0 - spun), 1e-12 * 10.0);
    const double way = 1e-3 * tau * (2.0 - (1.0 - left));
    const double order = step * step / (tau * tau) / 24.0;
    EXPECT_NEAR(after.position.x - kMiddle.x, way, 2.0 * order * way + 1e-18);
  }
}

TEST(DemDrag, ReachesTheTerminalVelocityOfItsLoad) {
  DemOptions options = inert();
  options.gravity = {0.0, 0.0, -9.81};
  Dem dem(options, {});
  dem.add({0, kMiddle, {}, {}});
  const double weight = -(kDensity - 1000.0) / kDensity * kMass * 9.81;
  DemStep last;
  for (int i = 0; i < 10; ++i) {
    last = dem.advance(5.0 * kMass / kDrag, {stokes_drag(0, {}, {1e-10, 0.0, 0.0})});
  }
  const DemState after = dem.states().at(0);
  // exp(-50) is left.
  EXPECT_NEAR(after.velocity.z, weight / kDrag, 1e-12 * std::abs(weight / kDrag));
  EXPECT_NEAR(after.velocity.x, 1e-10 / kDrag, 1e-12 * 1e-10 / kDrag);
  EXPECT_EQ(after.velocity.y, 0.0);  // nothing drives it sideways
  EXPECT_EQ(after.position.y, kMiddle.y);
  EXPECT_NEAR(last.means.at(0).force.z, weight, 1e-12 * std::abs(weight));
  EXPECT_EQ(last.means.at(0).force.x, 0.0);
}

}  // namespace
}  // namespace colloid::dem_test
