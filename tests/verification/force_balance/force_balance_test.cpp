// Forces on all surfaces against the drive: see README.md beside this file.
#include <cmath>

#include <gtest/gtest.h>

#include "flow/wall_forces.h"
#include "flow_cases.h"

namespace colloid {
namespace {

Vec3 total(const WallForces& forces) {
  Vec3 sum;
  for (const Wrench& w : forces.spheres) {
    sum += w.force;
  }
  for (const Vec3& f : forces.faces) {
    sum += f;
  }
  return sum;
}

TEST(ForceBalance, SurfacesTakeThePressureDropTimesTheArea) {
  for (int n : {20, 32}) {
    StokesProblem problem = cases::throat(n);
    const auto deposit = cases::dropped_deposit(25, 3);
    problem.spheres.insert(problem.spheres.end(), deposit.begin(), deposit.end());
    problem.drive = FlowDrive{};
    problem.drive.kind = FlowDrive::Kind::pressure_drop;
    problem.drive.pressure_drop = 5.0;
    StokesSolver solver(problem, StokesOptions{});
    solver.solve();
    const double drive = 5.0 * problem.box.size.x * problem.box.size.y;
    const Vec3 sum = total(wall_forces(solver));
    EXPECT_NEAR(sum.z / drive, -1.0, 1e-5) << n;  // flow and force along -z
    EXPECT_NEAR(sum.x / drive, 0.0, 1e-5) << n;
    EXPECT_NEAR(sum.y / drive, 0.0, 1e-5) << n;
  }
}

TEST(ForceBalance, NothingPushesWhereAVelocityIsGivenOnEveryFace) {
  StokesProblem problem = cases::throat(20);
  StokesSolver solver(problem, StokesOptions{});
  solver.solve();
  const WallForces forces = wall_forces(solver);
  // Inlet face and outlet included all momentum is accounted for.
  const double scale = solver.pressure_drop() * problem.box.size.x * problem.box.size.y;
  EXPECT_NEAR(norm(total(forces)) / scale, 0.0, 1e-5);
}

TEST(ForceBalance, BodyForceIsTakenByTheSpheres) {
  StokesProblem problem = cases::periodic_box({1e-4, 1e-4, 1e-4}, {24, 24, 24});
  problem.spheres = {{{3.1e-5, 2.7e-5, 3.3e-5}, 1.5e-5},
                     {{7.2e-5, 6.9e-5, 6.1e-5}, 2.2e-5}};
  problem.drive.kind = FlowDrive::Kind::body_force;
  problem.drive.body_force = {2e3, -1e3, 5e3};
  StokesSolver solver(problem, StokesOptions{});
  solver.solve();
  const Vec3 sum = total(wall_forces(solver));
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(sum[a] / (problem.drive.body_force[a] * 1e-12), 1.0, 1e-5);
  }
}

// The clean throat has the symmetry of a square: so must its forces.
TEST(Symmetry, ForcesOnTheFourCollectorsMirrorEachOther) {
  StokesSolver solver(cases::throat(24), StokesOptions{});
  solver.solve();
  const auto forces = wall_forces(solver).spheres;
  const double scale = norm(forces[0].force);
  for (int corner = 0; corner < 4; ++corner) {
    const double sx = corner % 2 == 0 ? 1.0 : -1.0;
    const double sy = corner / 2 == 0 ? 1.0 : -1.0;
    const Vec3 f = forces[static_cast<std::size_t>(corner)].force;
    EXPECT_NEAR((f.x * sx - forces[0].force.x) / scale, 0.0, 1e-5);
    EXPECT_NEAR((f.y * sy - forces[0].force.y) / scale, 0.0, 1e-5);
    EXPECT_NEAR((f.z - forces[0].force.z) / scale, 0.0, 1e-5);
  }
  EXPECT_NEAR(forces[0].force.x / forces[0].force.y, 1.0, 1e-5);
}

// Reciprocity (Lorentz): the force that a flow along x puts on a sphere along y is the
// one that the flow along y puts along x.  Holds in the limit; second order on the grid.
TEST(Symmetry, MobilityTensorIsSymmetric) {
  std::array<double, 2> error{};
  std::size_t m = 0;
  for (int n : {16, 32}) {
    std::array<Vec3, 2> mean;
    double diagonal = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      StokesProblem problem = cases::periodic_box({1e-4, 1e-4, 1e-4}, {n, n, n});
      problem.spheres = {{{3.1e-5, 2.7e-5, 5e-5}, 2.1e-5},
                         {{6.7e-5, 6.1e-5, 5e-5}, 2.1e-5}};
      problem.drive.kind = FlowDrive::Kind::body_force;
      problem.drive.body_force[axis] = 1e3;
      StokesSolver solver(problem, StokesOptions{});
      solver.solve();
      mean[static_cast<std::size_t>(axis)] = solver.superficial_velocity();
      diagonal = mean[static_cast<std::size_t>(axis)][axis];
    }
    EXPECT_GT(std::abs(mean[0].y) / diagonal, 0.01);  // the pair couples the axes
    error[m++] = std::abs(mean[0].y - mean[1].x) / diagonal;
  }
  std::printf("asymmetry of the mobility: %.1e, %.1e\n", error[0], error[1]);
  EXPECT_LT(error[0], 2e-3);
  EXPECT_LT(error[1], 5e-4);
}

}  // namespace
}  // namespace colloid
