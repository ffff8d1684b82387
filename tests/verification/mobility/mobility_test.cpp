// Bodies that move in a resolved flow: see README.md beside this file.
#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "flow/stokes_solver.h"
#include "flow/wall_forces.h"
#include "flow_cases.h"
#include "particles/unresolved_gap.h"
#include "physics/wall_resistance.h"

namespace colloid {
namespace {

constexpr double kRadius = 1e-5;  // [m]
constexpr double kMu = 1e-3;      // [Pa s]
const double kDrag = 6.0 * kPi * kMu * kRadius;

MovingBody sphere_at(const Vec3& centre) {
  return {centre, {{centre, kRadius}}};
}

StokesOptions tight(double tolerance) {
  StokesOptions options;
  options.tolerance = tolerance;
  return options;
}

// A cube of `extent` radii with a wall below and above, n cells per radius.
StokesProblem cube(int n, int extent, FaceCondition sides) {
  StokesProblem problem;
  const double length = extent * kRadius;
  problem.box.size = {length, length, length};
  problem.box.faces = {
      sides, sides, sides, sides, FaceCondition::wall, FaceCondition::wall};
  problem.viscosity = kMu;
  problem.cells = {extent * n, extent * n, extent * n};
  return problem;
}

// A place off every symmetry of the grid, `gap` radii above the wall.
Vec3 place(const StokesProblem& problem, double gap, double shift = 0.37) {
  const double cell = problem.box.size.x / problem.cells[0];
  return {0.5 * problem.box.size.x + shift * cell,
          0.5 * problem.box.size.y + 0.61 * shift * cell, (1.0 + gap) * kRadius};
}

// Force of the normal motion over Stokes'.
double normal_resistance(int n, int extent, double gap) {
  StokesProblem problem = cube(n, extent, FaceCondition::wall);
  problem.box.faces[z_plus] = FaceCondition::outlet;
  StokesSolver solver(problem, tight(1e-6));
  const MovingBody body = sphere_at(place(problem, gap));
  solver.set_bodies({body});
  BodyBalance balance = free_bodies({body}, kMu);
  balance.motions.resize(6, 0);
  balance.given[2] = -1e-3;
  solver.solve(balance);
  return solver.body_wrench()[2] / (kDrag * 1e-3);
}

// Speed of a sphere that the shear carries, over that of the shear at its centre.
double shear_speed(int n, int extent, double gap) {
  StokesProblem problem = cube(n, extent, FaceCondition::periodic);
  problem.drive.kind = FlowDrive::Kind::shear_rate;
  problem.drive.shear_rate = 100.0;
  StokesSolver solver(problem, tight(1e-6));
  const MovingBody body = sphere_at(place(problem, gap));
  solver.set_bodies({body});
  solver.solve(free_bodies({body}, kMu));
  return solver.body_motion()[0] / (100.0 * body.centre.z);
}

// What an unbounded space would give, at the coarser and the finer resolution: the walls
// far away act like 1/L^power, found at the coarser one.
template <class Measure>
std::array<double, 2> unbounded(const Measure& measure, double gap, int power) {
  constexpr int kCoarse = 4;
  constexpr int kFine = 8;
  const double small = measure(kCoarse, 8, gap);
  const double large = measure(kCoarse, 16, gap);
  const double limit = large + (large - small) / (std::pow(2.0, power) - 1.0);
  return {limit, measure(kFine, 8, gap) + (limit - small)};
}

TEST(Mobility, NormalMotionTowardsAWall) {
  // A force along the normal beside a wall acts like r^-3 from afar (Blake 1971), and
  // what is far acts back on the sphere as weakly again.
  constexpr int kPower = 5;
  for (double gap : {0.5, 1.0}) {
    const double exact = wall_resistance(gap).f_n;
    const auto found = unbounded(normal_resistance, gap, kPower);
    EXPECT_NEAR(found[0] / exact, 1.0, 0.02) << gap;
    EXPECT_NEAR(found[1] / exact, 1.0, 0.005) << gap;
  }
}

TEST(Mobility, AFreeSphereInShearNearAWall) {
  constexpr int kPower = 3;  // stresslets
  for (double gap : {0.5431, 2.7622}) {
    const double exact = free_in_shear(gap).speed;
    const auto found = unbounded(shear_speed, gap, kPower);
    EXPECT_NEAR(found[0] / exact, 1.0, 0.01) << gap;
    EXPECT_NEAR(found[1] / exact, 1.0, 0.003) << gap;
  }
}

TEST(Mobility, LubricationCompletesNarrowGaps) {
  for (int n : {3, 5}) {
    for (double gap : {0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01}) {
      const double exact = wall_resistance(gap).f_n;
      const double seen = wall_resistance(gap_seen_by_grid(gap * n) / n).f_n;
      const double found = normal_resistance(n, 12, gap) + exact - seen;
      EXPECT_NEAR(found / exact, 1.0, 0.05) << gap << " at " << n;
    }
  }
}

TEST(Mobility, AHeldBodyIsAFixedSphere) {
  StokesProblem problem = cases::throat(24);
  const Sphere sphere{{4.1e-5, 5.7e-5, 6.3e-5}, 6.65e-6};
  StokesSolver moving(problem, tight(1e-9));
  const MovingBody body{sphere.center, {sphere}};
  moving.set_bodies({body});
  BodyBalance held = free_bodies({body}, problem.viscosity);
  held.motions.resize(6, 0);
  moving.solve(held);
  problem.spheres.push_back(sphere);
  StokesSolver fixed(problem, tight(1e-9));
  fixed.solve();
  const Wrench wrench = wall_forces(fixed).spheres.back();
  const double scale = norm(wrench.force);
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(moving.body_wrench()[a] / scale, wrench.force[a] / scale, 1e-7);
    EXPECT_NEAR(moving.body_wrench()[3 + a] / (scale * sphere.radius),
                wrench.torque[a] / (scale * sphere.radius), 1e-7);
  }
}

TEST(Mobility, FreeBodiesAreFreeOfForceAndTorque) {
  const StokesProblem problem = cases::throat(24);
  StokesSolver solver(problem, tight(1e-8));
  std::vector<MovingBody> bodies;
  const double a = 6.65e-6;
  for (const Vec3& x : {Vec3{4.1e-5, 5.7e-5, 1.1e-4}, Vec3{5.3e-5, 5.2e-5, 6.3e-5}}) {
    bodies.push_back({x, {{x, a}}});
  }
  // A rigid pair.
  const Vec3 x{5.0e-5, 4.0e-5, 9.0e-5};
  bodies.push_back({x, {{x + Vec3{a, 0, 0}, a}, {x - Vec3{a, 0, 0}, a}}});
  solver.set_bodies(bodies);
  solver.solve(free_bodies(bodies, problem.viscosity));
  const double scale = 6.0 * kPi * problem.viscosity * a * 1e-3;
  const Eigen::VectorXd wrench = solver.body_wrench();
  for (Eigen::Index n = 0; n < wrench.size(); ++n) {
    EXPECT_NEAR(wrench[n] / (scale * (n % 6 < 3 ? 1.0 : a)), 0.0, 1e-5) << n;
  }
  // The same by the traction that the field leaves on each sphere.
  const auto forces = wall_forces(solver).spheres;
  EXPECT_NEAR(norm(forces.at(4).force) / scale, 0.0, 1e-5);
  EXPECT_NEAR(norm(forces.at(6).force + forces.at(7).force) / scale, 0.0, 1e-5);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    EXPECT_LT(solver.body_motion()[6 * static_cast<Eigen::Index>(b) + 2], -4e-4);
  }
}

// Lorentz: the resistance of a body among walls is symmetric; in the discrete to the
// grid's error.
TEST(Mobility, ResistanceIsSymmetric) {
  double before = 0.0;
  for (int n : {24, 48}) {
    StokesProblem problem = cases::throat(n);
    problem.drive = {};
    const double a = 6.65e-6;
    const Vec3 x{3.6e-5, 4.4e-5, 5.3e-5};
    const MovingBody body{x, {{x, a}}};
    StokesSolver solver(problem, tight(1e-6));
    solver.set_bodies({body});
    BodyBalance balance = free_bodies({body}, problem.viscosity);
    balance.motions.resize(6, 0);
    Eigen::Matrix<double, 6, 6> resistance;
    Eigen::VectorXd arm(6);
    arm << 1, 1, 1, 1 / a, 1 / a, 1 / a;
    for (int m = 0; m < 6; ++m) {
      balance.given.setZero();
      balance.given[m] = 1e-3 * arm[m];
      solver.solve(balance);
      resistance.col(m) = -solver.body_wrench().cwiseProduct(arm);
    }
    const double skew = (resistance - resistance.transpose()).norm() / resistance.norm();
    EXPECT_LT(skew, n == 24 ? 0.02 : 0.006);
    if (before > 0.0) {
      EXPECT_LT(skew, before / 2.5);
    }
    before = skew;
    const Eigen::Matrix<double, 6, 6> mean = 0.5 * (resistance + resistance.transpose());
    EXPECT_GT(mean.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(),
              6.0 * kPi * problem.viscosity * a * 1e-3);
  }
}

// The velocity of a sphere depends on where it is within a cell as little as the grid's
// error allows.
TEST(Mobility, ASphereHardlyFeelsTheGridItCrosses) {
  for (const auto& [n, bound] : {std::pair{22, 2e-3}, std::pair{44, 5e-4}}) {
    StokesProblem problem = cases::throat(n * 16 / 22);
    problem.spheres.clear();
    problem.box.faces[z_minus] = FaceCondition::outlet;
    StokesSolver solver(problem, tight(1e-6));
    const double a = 96.6e-6 / (n * 16 / 22) * (n == 22 ? 2.75 : 5.5);
    const double cell = 96.6e-6 / problem.cells[0];
    double least = 1e300, most = 0.0;
    for (int s = 0; s < 8; ++s) {
      const Vec3 x{48.3e-6, 48.3e-6, 50e-6 + s * cell / 8.0};
      const MovingBody body{x, {{x, a}}};
      solver.set_bodies({body});
      solver.solve(free_bodies({body}, problem.viscosity));
      least = std::min(least, -solver.body_motion()[2]);
      most = std::max(most, -solver.body_motion()[2]);
    }
    EXPECT_LT(most / least - 1.0, bound);
  }
}

}  // namespace
}  // namespace colloid
