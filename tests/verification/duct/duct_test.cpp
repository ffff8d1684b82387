// Flow in ducts without grains: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "flow/interpolation.h"
#include "flow_cases.h"

namespace colloid {
namespace {

// A duct of width x height in cells, periodic along z, driven by a body force along -z.
StokesProblem duct(int width, int height) {
  const double cell = cases::kLength / width;
  StokesProblem problem =
      cases::periodic_box({cases::kLength, height * cell, 4 * cell}, {width, height, 4});
  for (std::size_t f = x_minus; f <= y_plus; ++f) {
    problem.box.faces[f] = FaceCondition::wall;
  }
  problem.drive.kind = FlowDrive::Kind::body_force;
  problem.drive.body_force = {0.0, 0.0, -1e4};
  return problem;
}

double relative_permeability(const StokesProblem& problem) {
  StokesSolver solver(problem, StokesOptions{});
  solver.solve();
  return solver.permeability() / (cases::kLength * cases::kLength);
}

struct Section {
  int ratio;     // long over short side
  double exact;  // k over the short side squared
};

class Duct : public ::testing::TestWithParam<Section> {};

TEST_P(Duct, PermeabilityConvergesAtSecondOrder) {
  const Section& section = GetParam();
  std::array<double, 3> error{};
  std::array<int, 3> cells{12, 24, 48};
  for (std::size_t m = 0; m < 3; ++m) {
    error[m] =
        relative_permeability(duct(cells[m], section.ratio * cells[m])) / section.exact -
        1;
    std::printf("1:%d  %d cells  error %+.2e  times n^2 %.3f\n", section.ratio, cells[m],
                error[m], error[m] * cells[m] * cells[m]);
    // The flux is a midpoint sum: off by h^2/24 times the profile's mean second
    // derivative, relative to the mean velocity 1/(24 k n^2).  The differences' own error
    // is smaller.
    EXPECT_LT(std::abs(error[m]), 1.0 / (24.0 * section.exact * cells[m] * cells[m]));
  }
  EXPECT_GT(error[0] / error[1], 3.0);
  EXPECT_GT(error[1] / error[2], 3.0);
}

// k/W^2: series solution of Poisson's equation (White 1991, eq 3-48).
INSTANTIATE_TEST_SUITE_P(Sections, Duct,
                         ::testing::Values(Section{1, 0.0351442537},
                                           Section{2, 0.0571704}, Section{4, 0.0702032}),
                         [](const ::testing::TestParamInfo<Section>& instance) {
                           return "OneTo" + std::to_string(instance.param.ratio);
                         });

// Between plates the scheme is exact at the cells' centres (differences of a parabola),
// so the flux is the midpoint sum, k = (1 + 1/(2 n^2))/12, to the accuracy of the solve.
TEST(Slit, FluxIsTheMidpointSumOfTheExactParabola) {
  for (int n : {8, 16, 31}) {
    StokesProblem problem = duct(n, 4);
    problem.box.faces[y_minus] = FaceCondition::periodic;
    problem.box.faces[y_plus] = FaceCondition::periodic;
    const double expected = (1.0 + 1.0 / (2.0 * n * n)) / 12.0;
    EXPECT_NEAR(relative_permeability(problem) / expected, 1.0, 3e-6) << n << " cells";
  }
}

// Symmetry faces: half a slit between a wall and its middle plane carries the same
// profile.
TEST(Slit, SymmetryFaceStandsForTheOtherHalf) {
  for (int n : {8, 16}) {
    StokesProblem problem = duct(n, 4);
    problem.box.faces = {FaceCondition::wall,     FaceCondition::symmetry,
                         FaceCondition::periodic, FaceCondition::periodic,
                         FaceCondition::periodic, FaceCondition::periodic};
    // Half of a slit of 2n cells: k = (2 W)^2 (1 + 1/(8 n^2))/12.
    const double expected = 4.0 * (1.0 + 1.0 / (8.0 * n * n)) / 12.0;
    EXPECT_NEAR(relative_permeability(problem) / expected, 1.0, 3e-6) << n << " cells";
  }
}

TEST(SquareDuct, LargestOverMeanVelocity) {
  constexpr double kExact = 2.09626;
  std::array<double, 2> error{};
  std::size_t m = 0;
  for (int n : {15, 31}) {  // odd: the axis is a cell's centre
    StokesSolver solver(duct(n, n), StokesOptions{});
    solver.solve();
    const double axis =
        velocity_at(solver, {cases::kLength / 2, cases::kLength / 2, 0.0}).z;
    error[m] = axis / solver.superficial_velocity().z / kExact - 1.0;
    // The mean is off by at most 1/(24 k n^2) = 1.2/n^2 (see above), the axis by no more.
    EXPECT_LT(std::abs(error[m]), 2.4 / (n * n));
    ++m;
  }
  EXPECT_GT(error[0] / error[1], 3.0);
}

// An open duct driven by a pressure drop or by its inlet velocity gives the permeability
// of the endless one, up to what the inlet's plug profile costs.
TEST(SquareDuct, OpenEndsUnderPressureDrop) {
  for (int n : {12, 24}) {
    StokesProblem problem = duct(n, n);
    problem.box.size.z = 2 * cases::kLength;
    problem.cells[2] = 2 * n;
    problem.box.faces[z_minus] = FaceCondition::outlet;
    problem.box.faces[z_plus] = FaceCondition::inlet;
    problem.drive = FlowDrive{};
    problem.drive.kind = FlowDrive::Kind::pressure_drop;
    problem.drive.pressure_drop = 10.0;
    EXPECT_NEAR(relative_permeability(problem), relative_permeability(duct(n, n)), 1e-6);
  }
}

// Plane Couette flow is linear: exact on any grid.
TEST(Couette, ShearIsExact) {
  StokesProblem problem = cases::periodic_box({1e-4, 1e-4, 1e-4}, {6, 5, 9});
  problem.box.faces[z_minus] = FaceCondition::wall;
  problem.box.faces[z_plus] = FaceCondition::wall;
  problem.drive.kind = FlowDrive::Kind::shear_rate;
  problem.drive.shear_rate = 100.0;
  StokesOptions options;
  options.tolerance = 1e-9;
  StokesSolver solver(problem, options);
  solver.solve();
  for (double z : {0.0, 3e-6, 4.7e-5, 9.9e-5, 1e-4}) {
    const Vec3 u = velocity_at(solver, {3.3e-5, 2.1e-5, z});
    EXPECT_NEAR(u.x, 100.0 * z, 1e-9);
    EXPECT_NEAR(u.y, 0.0, 1e-9);
    EXPECT_NEAR(u.z, 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace colloid
