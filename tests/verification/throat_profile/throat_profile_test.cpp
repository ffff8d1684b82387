// Velocity profiles across the throat: see README.md beside this file.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "flow/interpolation.h"
#include "flow_cases.h"

namespace colloid {
namespace {

constexpr int kPoints = 97;

// Axial velocity along the diagonal and the side of the throat's narrowest plane, and
// along the axis of the box: the lines of the paper's Figure 4.
std::vector<double> profile(const StokesSolver& solver, int line) {
  const double width = solver.problem().box.size.x;
  std::vector<double> values;
  for (int n = 0; n < kPoints; ++n) {
    const double t = static_cast<double>(n) / (kPoints - 1);
    const Vec3 x = line == 0   ? Vec3{t * width, t * width, 0.5 * width}
                   : line == 1 ? Vec3{t * width, 0.5 * width, 0.5 * width}
                               : Vec3{0.5 * width, 0.5 * width, 1.5 * t * width};
    values.push_back(velocity_at(solver, x).z);
  }
  return values;
}

std::array<std::vector<double>, 3> profiles(int n) {
  StokesSolver solver(cases::throat(n), StokesOptions{});
  solver.solve();
  return {profile(solver, 0), profile(solver, 1), profile(solver, 2)};
}

TEST(ThroatProfile, ApproachesAFiveTimesFinerMesh) {
  const auto fine = profiles(120);
  const auto coarse = profiles(24);
  const auto coarser = profiles(12);
  for (std::size_t line = 0; line < 3; ++line) {
    double peak = 0.0;
    double square = 0.0;
    double square_coarser = 0.0;
    for (std::size_t n = 0; n < kPoints; ++n) {
      peak = std::max(peak, std::abs(fine[line][n]));
      square += std::pow(coarse[line][n] - fine[line][n], 2);
      square_coarser += std::pow(coarser[line][n] - fine[line][n], 2);
    }
    const double rms = std::sqrt(square / kPoints) / peak;
    const double rms_coarser = std::sqrt(square_coarser / kPoints) / peak;
    std::printf(
        "line %zu: rms error %.2f %% of the peak at 12 cells across, %.2f %% at 24\n",
        line, 100.0 * rms_coarser, 100.0 * rms);
    // Ten cells span the opening at 24: trilinear interpolation of a parabola alone costs
    // (1/10)^2 x 4/8 of the peak on average, both ways; twice that is allowed, and the
    // error of a coarser mesh must be larger by the square of the ratio, within 2.5
    // and 7.
    EXPECT_LT(rms, 0.03);
    EXPECT_GT(rms_coarser / rms, 2.5);
    EXPECT_LT(rms_coarser / rms, 7.0);
  }
}

TEST(ThroatProfile, VelocityVanishesOnSpheresAndWalls) {
  StokesSolver solver(cases::throat(24), StokesOptions{});
  solver.solve();
  const double width = solver.problem().box.size.x;
  const double radius = 0.5 * width;
  for (int n = 1; n < 20; ++n) {
    const double angle = 0.5 * kPi * n / 20;
    // On the first collector's surface, in the throat's plane.
    const Vec3 on{radius * std::cos(angle), radius * std::sin(angle), 0.5 * width};
    EXPECT_NEAR(norm(velocity_at(solver, on)), 0.0, 1e-6 * 5e-3);
    // Close to it the speed is proportional to the distance.
    const Vec3 out = on * (1.0 / radius);
    Vec3 near = on;
    near += Vec3{out.x, out.y, 0.0} * 2e-8;
    Vec3 twice = on;
    twice += Vec3{out.x, out.y, 0.0} * 4e-8;
    const double ratio =
        norm(velocity_at(solver, twice)) / norm(velocity_at(solver, near));
    EXPECT_NEAR(ratio, 2.0, 0.05) << angle;
  }
  EXPECT_EQ(norm(velocity_at(solver, {0.0, 0.5 * width, 1.2 * width})), 0.0);
}

}  // namespace
}  // namespace colloid
