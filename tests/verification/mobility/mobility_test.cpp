#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flow/stokes_solver.h"
#include "flow/wall_forces.h"
#include "flow_cases.h"

namespace colloid {
namespace {

// Sphere of radius 1 in shear above a wall; box L x L x H.
StokesProblem shear_box(int cells_per_radius, int extent) {
  StokesProblem p;
  const double a = 1e-5;
  p.box.size = {extent * a, extent * a, extent * a};
  p.box.faces = {FaceCondition::periodic, FaceCondition::periodic,
                 FaceCondition::periodic, FaceCondition::periodic, FaceCondition::wall,
                 FaceCondition::wall};
  p.drive.kind = FlowDrive::Kind::shear_rate;
  p.drive.shear_rate = 100.0;
  p.cells = {extent * cells_per_radius, extent * cells_per_radius,
             extent * cells_per_radius};
  return p;
}

TEST(Mobility, Scratch) {
  const double a = 1e-5;
  for (int ext : {10, 16, 24}) { const int n = ext == 24 ? 3 : 4;
    StokesProblem p = shear_box(n, ext);
    for (double h : {3.7622, 1.5431, 1.1276}) {
      for (double shift : {0.0, 0.37}) {
        StokesOptions options;
        StokesSolver solver(p, options);
        const double cell = a / n;
        MovingBody body{{5 * a + shift * cell, 5 * a, h * a}, {}}; std::printf("ext %d ", ext);
        body.spheres = {{body.centre, a}};
        solver.set_bodies({body});
        BodyBalance b = free_bodies({body}, p.viscosity);
        solver.solve(b);
        const auto v = solver.body_motion();
        const auto w = solver.body_wrench();
        const auto f = wall_forces(solver).spheres.at(0);
        const double u = v[0] / (100.0 * h * a);
        std::printf("n %d h %.4f shift %.2f  U/hS %.5f  w/S %.5f  w_y %.2e  H %.2e wf %.2e its %d wu %.0f setup %.1f ms\n", n, h,
                    shift, u, v[4] / 100.0, v[2], w.norm() / (6 * M_PI * 1e-3 * a * v[0]), norm(f.force) / (6 * M_PI * 1e-3 * a * v[0]), solver.statistics().iterations, solver.statistics().work_units, solver.statistics().setup_seconds*1e3);
      }
    }
  }
}

}  // namespace
}  // namespace colloid
