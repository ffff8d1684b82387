// Drag on a periodic simple-cubic array of spheres: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "flow/wall_forces.h"
#include "flow_cases.h"

namespace colloid {
namespace {

struct Case {
  double c;                     // solid fraction
  double drag;                  // K, Zick & Homsy 1982
  std::array<int, 3> n;         // cells per period: each twice the one before
  std::array<double, 3> bound;  // largest relative error allowed
};

class SimpleCubicArray : public ::testing::TestWithParam<Case> {};

// Permeability gives K of the array: k = L^3/(6 pi a K).
double drag_by_permeability(const StokesSolver& solver, double radius) {
  return std::pow(cases::kLength, 3) / (6.0 * kPi * radius * solver.permeability());
}

TEST_P(SimpleCubicArray, ApproachesZickAndHomsyAtSecondOrder) {
  const Case& k = GetParam();
  const double a = cases::array_radius(k.c, cases::kLength);
  std::array<double, 3> drag{};
  for (std::size_t m = 0; m < 3; ++m) {
    StokesSolver solver(cases::simple_cubic_array(k.c, k.n[m]), StokesOptions{});
    const StokesStatistics& s = solver.solve();
    drag[m] = drag_by_permeability(solver, a);
    const double error = drag[m] / k.drag - 1.0;
    std::printf(
        "c %.3f  %5.1f cells per diameter  K %.5f  error %+.3f %%  %d iterations\n", k.c,
        2.0 * a / cases::kLength * k.n[m], drag[m], 100.0 * error, s.iterations);
    EXPECT_LT(std::abs(error), k.bound[m]);
    EXPECT_LE(s.iterations, 11);

    // The force on the sphere is an independent sum over its cut rows; both must agree to
    // the accuracy of the solve.
    const Wrench w = wall_forces(solver).spheres[0];
    const double by_force =
        w.force.z / (6.0 * kPi * cases::kViscosity * a * solver.superficial_velocity().z);
    EXPECT_NEAR(by_force / drag[m], 1.0, 1e-5);
  }
  const double order = std::log2((drag[1] - drag[0]) / (drag[2] - drag[1]));
  std::printf("c %.3f  observed order %.2f\n", k.c, order);
  EXPECT_GT(order, 1.6);
  EXPECT_LT(order, 2.6);
}

// 11.9, 23.8, 47.6 cells per diameter up to c = 0.216 (12.4, 24.8, 49.6 at 0.125), then
// 24, 48, 95.
INSTANTIATE_TEST_SUITE_P(
    Fractions, SimpleCubicArray,
    ::testing::Values(Case{0.027, 2.008, {32, 64, 128}, {0.015, 0.004, 0.001}},
                      Case{0.064, 2.810, {24, 48, 96}, {0.015, 0.004, 0.001}},
                      Case{0.125, 4.292, {20, 40, 80}, {0.015, 0.004, 0.001}},
                      Case{0.216, 7.442, {16, 32, 64}, {0.015, 0.004, 0.001}},
                      Case{0.343, 15.40, {28, 56, 112}, {0.05, 0.02, 0.005}},
                      Case{0.450, 28.1, {25, 50, 100}, {0.05, 0.02, 0.005}}),
    [](const ::testing::TestParamInfo<Case>& instance) {
      return "c" + std::to_string(static_cast<int>(std::lround(1000 * instance.param.c)));
    });

// Held superficial velocity and given force are the same linear problem.
TEST(SimpleCubicArrayDrives, HeldVelocityAndGivenForceAgree) {
  StokesProblem problem = cases::simple_cubic_array(0.216, 24);
  StokesSolver by_force(problem, StokesOptions{});
  by_force.solve();
  problem.drive = FlowDrive{};
  problem.drive.kind = FlowDrive::Kind::mean_velocity;
  problem.drive.mean_velocity = {0.0, 0.0, 2e-4};
  StokesSolver held(problem, StokesOptions{});
  held.solve();
  EXPECT_NEAR(held.superficial_velocity().z / 2e-4, 1.0, 1e-12);
  EXPECT_NEAR(held.superficial_velocity().x / 2e-4, 0.0, 1e-6);
  EXPECT_NEAR(held.permeability() / by_force.permeability(), 1.0, 1e-5);
}

// Where the sphere lies within a cell must not matter: the spread over positions is far
// below the error itself.
TEST(SimpleCubicArrayDrives, DragDependsLittleOnThePositionInTheCell) {
  double low = 1e300;
  double high = 0.0;
  for (int m = 0; m < 6; ++m) {
    StokesProblem problem = cases::simple_cubic_array(0.125, 16);
    const double cell = cases::kLength / 16;
    problem.spheres[0].center = {cases::kLength / 2 + 0.1 * m * cell,
                                 cases::kLength / 2 + 0.2 * cell,
                                 cases::kLength / 2 + 0.07 * m * cell};
    StokesSolver solver(problem, StokesOptions{});
    solver.solve();
    const double drag = drag_by_permeability(solver, problem.spheres[0].radius);
    low = std::min(low, drag);
    high = std::max(high, drag);
  }
  std::printf("spread of K over positions, 9.9 cells per diameter: %.3f %%\n",
              100.0 * (high / low - 1.0));
  EXPECT_LT(high / low - 1.0, 0.003);
}

}  // namespace
}  // namespace colloid
