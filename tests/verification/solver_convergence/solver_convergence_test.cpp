// What the solver costs and promises: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "flow/wall_forces.h"
#include "flow_cases.h"

namespace colloid {
namespace {

StokesProblem crowded_throat(int n, int colloids, std::uint64_t seed) {
  StokesProblem problem = cases::throat(n);
  const auto deposit = cases::dropped_deposit(colloids, seed);
  problem.spheres.insert(problem.spheres.end(), deposit.begin(), deposit.end());
  return problem;
}

// Iterations from zero to 1e-6 depend neither on size (19 thousand to 0.8 million cells,
// odd numbers too) nor on crowding (up to a throat filled with 70 touching colloids).
TEST(Iterations, DependNeitherOnSizeNorOnCrowding) {
  int fewest = 1000;
  int most = 0;
  for (int n : {20, 37, 40, 63, 80}) {
    for (int colloids : {0, 30, 70}) {
      StokesSolver solver(crowded_throat(n, colloids, 5), StokesOptions{});
      const StokesStatistics& s = solver.solve();
      std::printf("%3d cells across, %3d colloids: %2d iterations, %d sub-grid faces\n",
                  n, colloids, s.iterations, s.subgrid_openings);
      fewest = std::min(fewest, s.iterations);
      most = std::max(most, s.iterations);
      EXPECT_TRUE(s.converged);
      EXPECT_LE(s.relative_residual, 1e-6);
    }
  }
  EXPECT_LE(most, 10);
  EXPECT_LE(most - fewest, 4);
}

TEST(Iterations, TouchingSpheresInACubicArray) {
  for (int n : {16, 24, 41}) {
    StokesProblem problem = cases::simple_cubic_array(kPi / 6.0, n);
    StokesSolver solver(problem, StokesOptions{});
    EXPECT_LE(solver.solve().iterations, 11) << n;
    // K at contact: 42.1 (Zick & Homsy 1982), second order from below.
    const double drag = std::pow(cases::kLength, 3) /
                        (6.0 * kPi * problem.spheres[0].radius * solver.permeability());
    EXPECT_LT(std::abs(drag / 42.1 - 1.0), 15.0 / (n * n)) << n;
  }
}

TEST(WarmStart, AfterOneRetentionNeedsNoMoreThanFromZero) {
  StokesProblem problem = crowded_throat(40, 30, 8);
  StokesSolver solver(problem, StokesOptions{});
  const int cold = solver.solve().iterations;
  // No change: nothing to do.
  EXPECT_EQ(solver.solve().iterations, 0);
  const Sphere retained{{48.3e-6, 48.3e-6, 75e-6}, 6.65e-6};
  solver.add_spheres({retained});
  const int warm = solver.solve().iterations;
  EXPECT_LE(warm, cold);

  // The same flow as from zero with that sphere.
  problem.spheres.push_back(retained);
  StokesSolver fresh(problem, StokesOptions{});
  fresh.solve();
  EXPECT_NEAR(solver.pressure_drop() / fresh.pressure_drop(), 1.0, 1e-5);
  EXPECT_EQ(solver.rows().coefficients().row_scale,
            fresh.rows().coefficients().row_scale);
  std::printf("from zero %d iterations, after one retention %d\n", cold, warm);
}

TEST(Threads, ResultsAreTheSameBitForBit) {
  std::vector<StokesVector<double>> results;
  for (int threads : {1, 2, 3}) {
    StokesOptions options;
    options.threads = threads;
    StokesSolver solver(crowded_throat(20, 40, 2), options);
    solver.solve();
    results.push_back(solver.fields());
  }
  StokesProblem array = cases::simple_cubic_array(0.216, 17);
  std::vector<StokesVector<double>> periodic;
  for (int threads : {1, 2}) {
    StokesOptions options;
    options.threads = threads;
    StokesSolver solver(array, options);
    solver.solve();
    periodic.push_back(solver.fields());
  }
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(results[0].a[c], results[1].a[c]);
    EXPECT_EQ(results[0].a[c], results[2].a[c]);
    EXPECT_EQ(periodic[0].a[c], periodic[1].a[c]);
  }
}

// Mass: every open cell is free of divergence to the tolerance, and planes across the
// throat carry what the inlet gives.
TEST(Conservation, EveryPlaneCarriesTheSameFlux) {
  const StokesProblem problem = crowded_throat(24, 60, 4);
  StokesSolver solver(problem, StokesOptions{});
  solver.solve();
  const Grid& grid = solver.rows().grid();
  const double cell = problem.box.size.x / 24;
  for (int k = 0; k <= grid.cells[2]; ++k) {
    double flux = 0.0;
    for (int j = 0; j < grid.cells[1]; ++j) {
      for (int i = 0; i < grid.cells[0]; ++i) {
        flux -= solver.fields().a[u_z][grid.index(i, j, k)] * cell * cell;
      }
    }
    EXPECT_NEAR(flux / solver.flow_rate(), 1.0, 1e-5) << "plane " << k;
  }
}

// A plate of spheres that leaves one hole smaller than a cell.
StokesProblem pinhole(double hole, int n) {
  StokesProblem problem;
  const double width = 40e-6;
  problem.box.size = {width, width, width};
  problem.box.faces = {FaceCondition::wall, FaceCondition::wall,   FaceCondition::wall,
                       FaceCondition::wall, FaceCondition::outlet, FaceCondition::inlet};
  // Four spheres in a square, overlapping, so that the hole between them has this
  // diameter.
  const double radius = 14e-6;
  const double offset = (radius + 0.5 * hole) / std::sqrt(2.0);
  for (double sx : {-1.0, 1.0}) {
    for (double sy : {-1.0, 1.0}) {
      problem.spheres.push_back(
          {{0.5 * width + sx * offset, 0.5 * width + sy * offset, 0.5 * width}, radius});
    }
  }
  // The corners and edges around them are filled by larger ones.
  for (double sx : {0.0, 1.0}) {
    for (double sy : {0.0, 0.5, 1.0}) {
      if (sy == 0.5) {
        problem.spheres.push_back({{sx * width, 0.5 * width, 0.5 * width}, 11e-6});
        problem.spheres.push_back({{0.5 * width, sx * width, 0.5 * width}, 11e-6});
      } else {
        problem.spheres.push_back({{sx * width, sy * width, 0.5 * width}, 13e-6});
      }
    }
  }
  problem.viscosity = 1e-3;
  problem.cells = {n, n, n};
  return problem;
}

TEST(SubGridThroat, OpensWhereTheGridIsClosedButThePoreIsNot) {
  double narrow = 0.0;
  for (double hole : {2e-6, 1e-6, 0.5e-6}) {
    StokesProblem problem = pinhole(hole, 16);  // cells of 2.5 um
    problem.drive.kind = FlowDrive::Kind::inlet_velocity;
    problem.drive.inlet_velocity = 1e-6;
    StokesSolver solver(problem, StokesOptions{});
    const StokesStatistics& s = solver.solve();
    std::printf("hole %.1f um: %d faces opened, %d iterations, pressure drop %.3g Pa\n",
                hole * 1e6, s.subgrid_openings, s.iterations, solver.pressure_drop());
    EXPECT_TRUE(s.converged);
    EXPECT_GT(solver.pressure_drop(), narrow);  // narrower, so harder to pass
    narrow = solver.pressure_drop();
  }
}

TEST(Blocked, HeldFluxIsRefusedAndAPressureDropGivesNoFlow) {
  StokesProblem problem = pinhole(-2e-6, 16);  // the four spheres overlap in the middle
  problem.drive.kind = FlowDrive::Kind::inlet_velocity;
  problem.drive.inlet_velocity = 1e-6;
  EXPECT_THROW(StokesSolver(problem, StokesOptions{}), InputError);
  problem.drive = FlowDrive{};
  problem.drive.kind = FlowDrive::Kind::pressure_drop;
  problem.drive.pressure_drop = 10.0;
  StokesSolver solver(problem, StokesOptions{});
  solver.solve();
  EXPECT_NEAR(solver.permeability() / (problem.box.size.x * problem.box.size.x), 0.0,
              1e-9);
}

}  // namespace
}  // namespace colloid
