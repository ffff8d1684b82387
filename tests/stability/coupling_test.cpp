// The implicit coupling knows no limit where the explicit one has its own.  Rows of the
// map in results/evidence/stability; ratio of densities 1.05 but where said.
#include <gtest/gtest.h>

#include "coupling_case.h"
#include "gap_case.h"

namespace colloid {
namespace {

constexpr double kRelaxation = 1.03e-5;  // 2 rho_p a^2/(9 mu) [s]
const Vec3 kPlace{48.3e-6, 48.3e-6, 75e-6};
constexpr int kCells = 20;

TEST(TransientCoupling, ImplicitIsStableAtAnyStepAndDensity) {
  for (const double ratio : {0.5, 1.05, 8.0}) {
    for (const double steps_of : {0.01, 1.0}) {
      EXPECT_EQ(
          coupled_motion(true, ratio, steps_of * kRelaxation, 20, kPlace, kCells).outcome,
          Outcome::bounded)
          << steps_of << " relaxation times, density ratio " << ratio;
    }
    // The first steps from rest may pass the final speed; it is reached all the same.
    EXPECT_NE(
        coupled_motion(true, ratio, 100.0 * kRelaxation, 20, kPlace, kCells).outcome,
        Outcome::unstable)
        << ratio;
  }
}

TEST(TransientCoupling, ExplicitDivergesBeyondTheRelaxationTime) {
  EXPECT_EQ(coupled_motion(false, 1.05, 10.0 * kRelaxation, 20, kPlace, kCells).outcome,
            Outcome::unstable);
  // Half of the liquid's density: the added mass alone is as large as the body's.
  EXPECT_EQ(coupled_motion(false, 0.5, kRelaxation, 20, kPlace, kCells).outcome,
            Outcome::unstable);
}

TEST(TransientCoupling, LubricationIsStableAtAnyStepAndGap) {
  for (const Weight weight : {Weight::towards_wall, Weight::along_wall}) {
    for (const double gap : {0.1, 1e-2, 1e-4}) {
      for (const double steps_of : {0.3, 10.0}) {
        EXPECT_EQ(moved_at_wall(weight, gap, steps_of * kRelaxation, 20).outcome,
                  Outcome::bounded)
            << steps_of << " relaxation times, gap " << gap;
      }
    }
  }
}

}  // namespace
}  // namespace colloid
