// A colloid carried by the solver's own flow in a duct: see README.md beside this file.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/constants.h"
#include "tiers/deposit_flow.h"

namespace colloid {
namespace {

constexpr double kWidth = 60e-6;
constexpr double kRadius = 6.65e-6;
constexpr double kForce = 1e3;  // body force, along -z [N/m^3]
constexpr double kMu = 1e-3;

// Poisson's equation in a square, White (1991), Viscous Fluid Flow, eq. 3-48, and its
// gradient: u_z at (x, y).
constexpr int kTerms = 2000;

struct Duct {
  double u = 0.0, ux = 0.0, uy = 0.0;
};
Duct exact_duct(double x, double y) {
  const double h = 0.5 * kWidth;
  const double p = (x - h) / h;
  const double q = (y - h) / h;
  Duct d;
  for (int k = 0; k < kTerms; ++k) {
    const double alpha = (k + 0.5) * kPi;
    const double c = (k % 2 == 0 ? 4.0 : -4.0) * h * h / std::pow(alpha, 3);
    // cosh and sinh of alpha q over cosh alpha, without overflow.
    const double e = std::exp(alpha * (std::abs(q) - 1.0));
    const double f = std::exp(-2.0 * alpha * std::abs(q));
    const double under = 1.0 + std::exp(-2.0 * alpha);
    const double ch = e * (1.0 + f) / under;
    const double sh = std::copysign(e * (1.0 - f) / under, q);
    d.u += c * std::cos(alpha * p) * (1.0 - ch);
    d.ux -= c * alpha / h * std::sin(alpha * p) * (1.0 - ch);
    d.uy -= c * alpha / h * std::cos(alpha * p) * sh;
  }
  const double scale = -kForce / (2.0 * kMu);
  return {d.u * scale, d.ux * scale, d.uy * scale};
}

Scene duct_scene() {
  Scene scene;
  scene.geometry.box.size = {kWidth, kWidth, 0.5 * kWidth};
  scene.geometry.box.faces = {FaceCondition::wall,     FaceCondition::wall,
                              FaceCondition::wall,     FaceCondition::wall,
                              FaceCondition::periodic, FaceCondition::periodic};
  scene.fluid.viscosity = kMu;
  scene.drive.body_force = Vec3{0.0, 0.0, -kForce};
  scene.fidelity.tolerance = 1e-8;
  return scene;
}

struct Error {
  double velocity = 0.0;  // largest, over (G/mu) W^2
  double spin = 0.0;      // largest, over (G/mu) W
  double strain = 0.0;    // largest component, over (G/mu) W
};

// Largest errors over many places of the sphere, down to touching two walls.
Error largest_error(int cells) {
  const DepositFlow flow(duct_scene(), {cells, cells, cells / 2}, 1);
  Error error;
  constexpr int kPlaces = 9;
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      const double span = kWidth - 2.0 * kRadius;
      const Vec3 x{kRadius + span * (i + 0.013 * j) / kPlaces,
                   kRadius + span * (j + 0.5) / kPlaces, 0.21 * kWidth};
      const AmbientMotion got = flow.around(x, kRadius);
      const Duct exact = exact_duct(x.x, x.y);
      // Faxen: u + (a^2/6) lap u, and mu lap u = G here; half the vorticity.
      const Vec3 u{0.0, 0.0, exact.u + kRadius * kRadius / 6.0 * kForce / kMu};
      const Vec3 w{0.5 * exact.uy, -0.5 * exact.ux, 0.0};
      error.velocity = std::max(
          error.velocity, norm(got.velocity - u) / (kForce / kMu * kWidth * kWidth));
      error.spin = std::max(error.spin, norm(got.spin - w) / (kForce / kMu * kWidth));
      Matrix3 strain = Matrix3::Zero();  // its Laplacian vanishes
      strain(0, 2) = strain(2, 0) = 0.5 * exact.ux;
      strain(1, 2) = strain(2, 1) = 0.5 * exact.uy;
      error.strain =
          std::max(error.strain, (got.strain - strain).lpNorm<Eigen::Infinity>() /
                                     (kForce / kMu * kWidth));
    }
  }
  return error;
}

TEST(Faxen, AverageOverTheSphereConvergesAtSecondOrder) {
  Error first;
  Error last;
  for (int cells : {12, 24, 48}) {
    last = largest_error(cells);
    const double h2 = 1.0 / (cells * cells);
    std::printf(
        "%d cells: velocity %.2e (over h^2 %.3f), spin %.2e (over h^2 W/a %.3f), strain "
        "%.2e\n",
        cells, last.velocity, last.velocity / h2, last.spin,
        last.spin / h2 * kRadius / kWidth, last.strain);
    // README: interpolation h^2/8 (|u_xx| + |u_yy|) = h^2/8 G/mu, differences h^2/24.
    EXPECT_LT(last.velocity, (1.0 / 8.0 + 1.0 / 24.0) * h2);
    EXPECT_LT(last.spin, 1.5 * (1.0 / 8.0 + 1.0 / 24.0) * h2 * kWidth / kRadius);
    EXPECT_LT(last.strain, 1.5 * (1.0 / 8.0 + 1.0 / 24.0) * h2 * kWidth / kRadius);
    first = cells == 12 ? last : first;
  }
  // Sixteen at second order.  How the twelve points lie in their cells changes with the
  // grid, so that the error of the spin, a difference of velocities, scatters.
  EXPECT_GT(first.velocity / last.velocity, 12.0);
  EXPECT_GT(first.spin / last.spin, 8.0);
  EXPECT_GT(first.strain / last.strain, 8.0);
}

// The reference solves the equation: its Laplacian and its walls.
TEST(Faxen, ReferenceSolvesPoissonsEquation) {
  const double e = 1e-3 * kWidth;
  const double x = 0.3 * kWidth, y = 0.45 * kWidth;
  const double lap =
      (exact_duct(x + e, y).u + exact_duct(x - e, y).u + exact_duct(x, y + e).u +
       exact_duct(x, y - e).u - 4.0 * exact_duct(x, y).u) /
      (e * e);
  // What is left out of the Laplacian: less than its first term, 2/alpha.
  EXPECT_NEAR(lap / (kForce / kMu), 1.0, 2.0 / (kTerms * kPi) + 1e-4);
  EXPECT_NEAR(exact_duct(0.0, y).u / exact_duct(x, y).u, 0.0, 1e-5);
  EXPECT_NEAR(exact_duct(x, kWidth).u / exact_duct(x, y).u, 0.0, 1e-12);
  EXPECT_NEAR(
      (exact_duct(x + e, y).u - exact_duct(x - e, y).u) / (2.0 * e) / exact_duct(x, y).ux,
      1.0, 1e-4);
  EXPECT_NEAR(
      (exact_duct(x, y + e).u - exact_duct(x, y - e).u) / (2.0 * e) / exact_duct(x, y).uy,
      1.0, 1e-4);
}

}  // namespace
}  // namespace colloid
