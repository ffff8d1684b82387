#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flow/stokes_solver.h"
#include "flow_cases.h"
#include "physics/wall_resistance.h"

namespace colloid {
namespace {

TEST(Mobility, Scratch) {
  const double a = 1e-5;
  for (int n : {3, 5}) {
    for (int extent : {14}) {
    for (double gap : {1.0, 0.5, 0.3, 0.2, 0.1, 0.02}) {
      for (double shift : {0.45}) {
      StokesProblem p;
      p.box.size = {extent * a, extent * a, extent * a};
      p.box.faces = {FaceCondition::wall, FaceCondition::wall,
                 FaceCondition::wall, FaceCondition::wall, FaceCondition::wall,
                 FaceCondition::outlet};
      p.cells = {extent * n, extent * n, extent * n};
      StokesSolver solver(p, StokesOptions{1e-5});
      const double cell = a / n;
      MovingBody body{{0.5 * extent * a + shift * cell, 0.5 * extent * a+shift*cell, (1 + gap) * a}, {}};
      body.spheres = {{body.centre, a}};
      solver.set_bodies({body});
      BodyBalance b = free_bodies({body}, p.viscosity);
      b.motions.resize(6, 0);
      double r[3];
      const int axis[3] = {2, 0, 4};
      for (int m = 0; m < 3; ++m) {
        b.given.setZero();
        b.given[axis[m]] = m == 2 ? 1e-3 / a : 1e-3;
        solver.solve(b);
        r[m] = -solver.body_wrench()[axis[m]] / (6 * M_PI * 1e-3 * a * 1e-3) * (m == 2 ? 0.75 / a : 1.0);
      }
      const WallResistance w = wall_resistance(gap);
      std::printf("n %d gap %.3f a = %.2f cells shift %.2f:  f_n %.4f /%.4f = %.3f  f_t %.4f/%.4f = %.3f  g %.4f/%.4f\n", n, gap, gap * n, shift, r[0], w.f_n, r[0]/w.f_n, r[1], w.f_t, r[1]/w.f_t, r[2], w.t_r);
      }
    }
    }
  }
}

}  // namespace
}  // namespace colloid
