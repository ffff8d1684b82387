// Array that moves, order of accuracy, dissipation: see README.md beside this file.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "flow/interpolation.h"
#include "flow/stokes_solver.h"
#include "flow_cases.h"

namespace colloid {
namespace {

StokesOptions tight(double tolerance) {
  StokesOptions options;
  options.tolerance = tolerance;
  return options;
}

Eigen::VectorXd velocity_only(const Vec3& v) {
  Eigen::VectorXd six = Eigen::VectorXd::Zero(6);
  six.head<3>() << v.x, v.y, v.z;
  return six;
}

// K of F = 6 pi mu a K U of the array of solid fraction c, whose sphere moves at `speed`
// through the liquid that a body force drives, mean over places within a cell.
double drag_of_array(double c, int n, double speed) {
  StokesProblem problem = cases::simple_cubic_array(c, n);
  const Sphere sphere = problem.spheres[0];
  problem.spheres.clear();
  StokesSolver solver(problem, tight(1e-7));
  double sum = 0.0;
  constexpr int kPlaces = 4;
  for (int m = 0; m < kPlaces; ++m) {
    const double cell = cases::kLength / n;
    const Vec3 x = sphere.center + Vec3{0.25, 0.15, 0.35} * (m * cell);
    const MovingBody body{x, {{x, sphere.radius}}};
    solver.set_bodies({body});
    BodyBalance balance = free_bodies({body}, problem.viscosity);
    balance.motions.resize(6, 0);
    balance.given = velocity_only({0, 0, speed});
    solver.solve(balance);
    const double force = solver.body_wrench()[2];
    const double relative = solver.superficial_velocity().z - speed;
    sum += force / (6.0 * kPi * problem.viscosity * sphere.radius * relative);
  }
  return sum / kPlaces;
}

// Zick & Homsy (1982), four digits.  The same array held in a stream and moved through
// it: by another path through the rows, to the grid's error.  Error of second order: 0.02
// at 16 cells an edge (10 a diameter) and as (16/n)^2 beyond.
TEST(MovingArray, HasTheDragOfTheHeldOne) {
  constexpr double kExact = 4.292;
  constexpr double kDigits = 2e-4;
  std::vector<double> error;
  for (int n : {16, 32}) {
    const double held = drag_of_array(0.125, n, 0.0) / kExact - 1.0;
    const double moving = drag_of_array(0.125, n, -2e-3) / kExact - 1.0;
    std::printf("array, %2d cells an edge: K held %+.3f %%, moving %+.3f %%\n", n,
                100 * held, 100 * moving);
    const double bound = 0.02 * 256.0 / (n * n) + kDigits;
    EXPECT_NEAR(held, 0.0, bound);
    EXPECT_NEAR(moving, 0.0, bound);
    EXPECT_NEAR(moving, held, 0.1 * bound);
    error.push_back(moving);
  }
  const double order = std::log2(std::abs(error[0] / error[1]));
  std::printf("order %.2f\n", order);
  EXPECT_GT(order, 1.5);
}

// 2 mu e:e over the liquid: slopes of the velocity at a raster of `fine` points a cell
// and axis, by differences of a quarter of a cell that stay out of the spheres.
double dissipation(const StokesSolver& solver, const std::vector<Sphere>& spheres,
                   int fine) {
  const StokesProblem& problem = solver.problem();
  const Vec3 size = problem.box.size;
  const double step = size.x / problem.cells[0] / fine;
  const double widest = 0.125 * step * fine;
  double sum = 0.0;
  std::array<long, 3> count{};
  for (int a = 0; a < 3; ++a) {
    count[static_cast<std::size_t>(a)] = std::lround(size[a] / step);
  }
  for (long k = 0; k < count[2]; ++k) {
    for (long j = 0; j < count[1]; ++j) {
      for (long i = 0; i < count[0]; ++i) {
        const Vec3 x = Vec3{static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5,
                            static_cast<double>(k) + 0.5} *
                       step;
        double clearance = std::min(size.x, size.y);
        for (const Sphere& sphere : spheres) {
          clearance = std::min(clearance, norm(x - sphere.center) - sphere.radius);
        }
        if (clearance <= 0.0) {
          continue;
        }
        const double half = std::min(widest, 0.9 * clearance);
        Eigen::Matrix3d slope;
        for (int a = 0; a < 3; ++a) {
          Vec3 e;
          e[a] = half;
          const Vec3 d =
              (velocity_at(solver, x + e) - velocity_at(solver, x - e)) * (0.5 / half);
          slope.col(a) << d.x, d.y, d.z;
        }
        const Eigen::Matrix3d strain = 0.5 * (slope + slope.transpose());
        sum += 2.0 * problem.viscosity * strain.squaredNorm();
      }
    }
  }
  return sum * step * step * step;
}

// A duct with a free sphere under a force and a torque, driven by a body force: what
// heats the liquid is the work of the drive and of the loads.  The quadrature near
// surfaces is of first order in a layer of a cell: second order.
TEST(Dissipation, IsTheWorkOfDriveAndLoads) {
  double before = 0.0;
  for (int n : {16, 32}) {
    StokesProblem problem;
    const double width = 60e-6;
    problem.box.size = {width, width, width};
    problem.box.faces = {FaceCondition::wall,     FaceCondition::wall,
                         FaceCondition::wall,     FaceCondition::wall,
                         FaceCondition::periodic, FaceCondition::periodic};
    problem.viscosity = 1e-3;
    problem.cells = {n, n, n};
    problem.drive.kind = FlowDrive::Kind::body_force;
    problem.drive.body_force = {0, 0, 5e3};
    StokesSolver solver(problem, tight(1e-7));
    const double a = 12e-6;
    const Vec3 x{27e-6, 31e-6, 30e-6};
    const MovingBody body{x, {{x, a}}};
    solver.set_bodies({body});
    BodyBalance balance = free_bodies({body}, problem.viscosity);
    const double force = 6.0 * kPi * problem.viscosity * a * 1e-3;
    balance.load << 0.3 * force, 0, -1.5 * force, 0, force * a, 0;
    solver.solve(balance);
    const double volume = width * width * width;
    const double drive =
        problem.drive.body_force.z * solver.superficial_velocity().z * volume;
    const double loads = balance.load.dot(solver.body_motion());
    const double heat = dissipation(solver, body.spheres, 2);
    const double error = heat / (drive + loads) - 1.0;
    std::printf(
        "%2d cells: work of the drive %.4g W, of the loads %.4g W; dissipation "
        "%+.2f %%; residual %.1e; force and torque left over: ",
        n, drive, loads, 100 * error, solver.statistics().relative_residual);
    const Eigen::VectorXd left = solver.body_wrench() + balance.load;
    for (Eigen::Index m = 0; m < 6; ++m) {
      const double relative = left[m] / (force * (m < 3 ? 1.0 : a));
      std::printf("%.1e ", relative);
      EXPECT_NEAR(relative, 0.0, 1e-5);
    }
    std::printf("\n");
    EXPECT_NEAR(error, 0.0, 0.06 * 256.0 / (n * n));
    if (before != 0.0) {
      EXPECT_LT(std::abs(error), 0.45 * std::abs(before));
    }
    before = error;
  }
}

}  // namespace
}  // namespace colloid
