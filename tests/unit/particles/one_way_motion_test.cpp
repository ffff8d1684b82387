#include "particles/one_way_motion.h"

#include <gtest/gtest.h>

#include "verification/motion_cases.h"

namespace colloid {
namespace {

// A force on the colloid with the first id, far from everything: Stokes' law for it
// alone.
TEST(OneWayMotion, PushesTheColloidsThatAreGivenForces) {
  OneWayOptions options = cases::free_of_hindrance(1e-9);
  options.given = {{{1e-12, 0.0, 0.0}, {0.0, 2e-19, 0.0}}};
  const cases::Setting setting(options, cases::at_rest, cases::wide_box(1e-3), {});
  const Motion motion = setting.model->motion(
      {cases::colloid_at({5e-4, 5e-4, 5e-4}, 0), cases::colloid_at({2e-4, 5e-4, 5e-4}, 1),
       cases::colloid_at({8e-4, 5e-4, 5e-4}, -1)},
      {}, {});
  EXPECT_NEAR(motion.velocity[0].x, 1e-12 / cases::kDrag, 1e-12 * 1e-12 / cases::kDrag);
  const double turn = 4.0 / 3.0 * cases::kDrag * cases::kRadius * cases::kRadius;
  EXPECT_NEAR(motion.spin[0].y, 2e-19 / turn, 1e-12 * 2e-19 / turn);
  for (const std::size_t not_given : {1U, 2U}) {
    EXPECT_EQ(motion.velocity[not_given].x, 0.0);
    EXPECT_EQ(motion.spin[not_given].y, 0.0);
  }
}

}  // namespace
}  // namespace colloid
