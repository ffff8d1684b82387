// The operator and the solver against a solution made up: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "core/constants.h"
#include "flow/fgmres.h"
#include "flow/multigrid.h"

namespace colloid {
namespace {

// A divergence-free velocity and a pressure of period 1 in every direction; mu = 1.
constexpr double kWave = 2.0 * kPi;

double velocity(int c, const Vec3& x) {
  const double sx = std::sin(kWave * x.x), cx = std::cos(kWave * x.x);
  const double sy = std::sin(kWave * x.y), cy = std::cos(kWave * x.y);
  const double sz = std::sin(kWave * x.z), cz = std::cos(kWave * x.z);
  return c == 0 ? sx * cy * cz : (c == 1 ? cx * sy * cz : -2.0 * cx * cy * sz);
}

double made_pressure(const Vec3& x) {
  return std::cos(kWave * x.x) * std::sin(kWave * (x.y + x.z));
}

// f = -lap u + grad p
double force(int c, const Vec3& x) {
  const double px = -kWave * std::sin(kWave * x.x) * std::sin(kWave * (x.y + x.z));
  const double pyz = kWave * std::cos(kWave * x.x) * std::cos(kWave * (x.y + x.z));
  return 3.0 * kWave * kWave * velocity(c, x) + (c == 0 ? px : pyz);
}

struct Errors {
  double velocity = 0.0;  // largest
  double pressure = 0.0;
  int iterations = 0;
};

// The unit cube in n x m x n cells; uneven numbers put a narrow cell into the coarse
// levels.
Errors solve(int n, int m) {
  FlowFaces faces;
  for (FlowFace& f : faces) {
    f.kind = FlowFace::Kind::periodic;
  }
  const WallRows rows(make_grid({1.0, 1.0, 1.0}, {n, m, n}, {true, true, true}), faces);
  const Grid& grid = rows.grid();
  Multigrid multigrid(rows, faces, {}, CycleOptions{}, 1);
  StokesVector<double> b(grid.size), x(grid.size);
  const auto for_all = [&](const auto& visit) {
    for (int k = 0; k < n; ++k) {
      for (int j = 0; j < m; ++j) {
        for (int i = 0; i < n; ++i) {
          visit(i, j, k, grid.index(i, j, k));
        }
      }
    }
  };
  for_all([&](int i, int j, int k, std::size_t q) {
    for (int c = 0; c < 3; ++c) {
      b[c][q] = force(c, grid.location(c, i, j, k)) *
                static_cast<double>(
                    rows.coefficients().row_scale[static_cast<std::size_t>(c)][q]);
    }
  });
  KrylovOptions options;
  options.target = 1e-8 * norm(view(rows), b, 1);
  const KrylovStatistics s = Fgmres(rows).solve(
      b, x,
      [&](const StokesVector<float>& r, StokesVector<float>& z, bool light) {
        multigrid.apply(r, z, light);
      },
      options);
  EXPECT_TRUE(s.converged);

  // Mean velocity and mean pressure are free in a periodic box.
  std::array<double, 4> mean{};
  const auto exact = [&](int c, int i, int j, int k) {
    const Vec3 at = grid.location(c, i, j, k);
    return c == pressure ? made_pressure(at) : velocity(c, at);
  };
  for_all([&](int i, int j, int k, std::size_t q) {
    for (int c = 0; c < 4; ++c) {
      mean[static_cast<std::size_t>(c)] += x[c][q] - exact(c, i, j, k);
    }
  });
  Errors errors;
  errors.iterations = s.iterations;
  for_all([&](int i, int j, int k, std::size_t q) {
    for (int c = 0; c < 4; ++c) {
      const double shift =
          mean[static_cast<std::size_t>(c)] / static_cast<double>(grid.cell_count());
      const double error = std::abs(x[c][q] - shift - exact(c, i, j, k));
      double& worst = c == pressure ? errors.pressure : errors.velocity;
      worst = std::max(worst, error);
    }
  });
  std::printf("%3d x %3d x %3d  velocity %.2e  pressure %.2e  %d iterations\n", n, m, n,
              errors.velocity, errors.pressure, errors.iterations);
  return errors;
}

// Leading truncation: second differences are off by (2 pi h)^2/12 of themselves,
// divergence and gradient by (2 pi h)^2/24.  The solution inherits a few times that:
// bound 4/12.
TEST(ManufacturedSolution, ConvergesAtSecondOrderInTheMaximumNorm) {
  std::array<Errors, 3> errors;
  std::array<int, 3> cells{16, 32, 64};
  for (std::size_t m = 0; m < 3; ++m) {
    errors[m] = solve(cells[m], cells[m]);
    const double square = std::pow(kWave / cells[m], 2);
    EXPECT_LT(errors[m].velocity, square / 3.0 * 2.0);
    EXPECT_LT(errors[m].pressure, square / 3.0 * 6.0 * kWave);
  }
  for (std::size_t m = 1; m < 3; ++m) {
    EXPECT_NEAR(std::log2(errors[m - 1].velocity / errors[m].velocity), 2.0, 0.15);
    EXPECT_NEAR(std::log2(errors[m - 1].pressure / errors[m].pressure), 2.0, 0.15);
  }
}

TEST(ManufacturedSolution, UnevenNumbersOfCellsKeepTheErrorAndConverge) {
  const Errors even = solve(32, 32);
  const Errors odd = solve(33, 31);
  EXPECT_NEAR(odd.velocity / even.velocity, 1.0, 0.15);
  // Powers of two in a cube are the best case there is (6 iterations); uneven numbers
  // must stay within what crowded throats need.
  EXPECT_LE(even.iterations, 8);
  EXPECT_LE(odd.iterations, 11);
}

}  // namespace
}  // namespace colloid
