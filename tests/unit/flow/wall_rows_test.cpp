#include "flow/wall_rows.h"

#include <cmath>

#include <gtest/gtest.h>

#include "flow/kernels.h"

namespace colloid {
namespace {

FlowFaces periodic_faces() {
  FlowFaces faces;
  for (FlowFace& f : faces) {
    f.kind = FlowFace::Kind::periodic;
  }
  return faces;
}

// A sphere so large that its surface is plane on the scale of a cell: the row of every
// open face must annihilate the linear profile, in units of the row's diagonal.
TEST(WallRows, AnnihilateTheLinearProfileOfAWallInAnyPosition) {
  const int n = 12;
  for (const Vec3& direction : {Vec3{0.0, 0.0, 1.0}, Vec3{0.6, 0.0, 0.8},
                                Vec3{0.48, 0.6, 0.64}, Vec3{-0.3, 0.2, 0.93}}) {
    for (double offset : {0.0, 0.21, 0.5, 0.83}) {
      FlowFaces faces;  // walls; rows beside them are left out below
      WallRows rows(make_grid({12.0, 12.0, 12.0}, {n, n, n}, {false, false, false}),
                    faces);
      const double radius = 1e5;
      const Vec3 unit = direction * (1.0 / norm(direction));
      const Vec3 touched = Vec3{6.0, 6.0, 6.0} + unit * offset;
      rows.add(Sphere{touched - unit * radius, radius});
      const Grid& grid = rows.grid();
      StokesVector<double> u(grid.size), f(grid.size), r(grid.size);
      for (int c = 0; c < 3; ++c) {
        for (int k = 0; k < grid.end(c, 2); ++k) {
          for (int j = 0; j < grid.end(c, 1); ++j) {
            for (int i = 0; i < grid.end(c, 0); ++i) {
              const std::size_t q = grid.index(i, j, k);
              if (rows.coefficients().row_scale[static_cast<std::size_t>(c)][q] > 0.0F) {
                // Beyond the walls' reach the moment is the distance itself.
                const double d = dot(grid.location(c, i, j, k) - touched, unit);
                u[c][q] = rows.away(c, {i, j, k}) ? d : rows.moment(c, {i, j, k});
              }
            }
          }
        }
      }
      const LevelView level = view(rows);
      int cut = 0;
      for (int k = 0; k < level.end[2]; ++k) {
        residual_plane(level, u, f, r, k);
      }
      for (int c = 0; c < 3; ++c) {
        for (int k = 2; k < n - 2; ++k) {
          for (int j = 2; j < n - 2; ++j) {
            for (int i = 2; i < n - 2; ++i) {
              const std::size_t q = grid.index(i, j, k);
              if (rows.coefficients().row_scale[static_cast<std::size_t>(c)][q] <= 0.0F) {
                continue;
              }
              cut += rows.away(c, {i, j, k}) ? 0 : 1;
              // Coefficients are floats; a neighbour below kClosed counts as closed.
              EXPECT_NEAR(r[c][q] / rows.coefficients().diagonal, 0.0, 2e-4);
            }
          }
        }
      }
      EXPECT_GT(cut, 100);
    }
  }
}

// Rows made one sphere after the other are those made at once.
TEST(WallRows, DoNotDependOnTheOrderInWhichSpheresCome) {
  const Grid grid = make_grid({20.0, 20.0, 20.0}, {20, 20, 20}, {true, true, true});
  const std::vector<Sphere> spheres{
      {{5.3, 6.1, 7.2}, 3.3}, {{10.9, 8.0, 7.7}, 2.9}, {{19.5, 0.3, 10.0}, 4.1}};
  WallRows together(grid, periodic_faces());
  together.add(spheres);
  WallRows one_by_one(grid, periodic_faces());
  for (const Sphere& s : spheres) {
    one_by_one.add(s);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(together.coefficients().row_scale[c],
              one_by_one.coefficients().row_scale[c]);
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_EQ(together.coefficients().link[c][a], one_by_one.coefficients().link[c][a]);
    }
  }
  EXPECT_EQ(together.coefficients().cell_scale, one_by_one.coefficients().cell_scale);
}

// A sphere and its image a period away are the same sphere.
TEST(WallRows, ImagesActAcrossPeriodicFaces) {
  const Grid grid = make_grid({8.0, 8.0, 8.0}, {8, 8, 8}, {true, true, true});
  WallRows inside(grid, periodic_faces());
  inside.add(Sphere{{0.25, 4.0, 7.5}, 2.0});
  WallRows outside(grid, periodic_faces());
  outside.add(Sphere{{8.25, 4.0, -0.5}, 2.0});
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(inside.coefficients().row_scale[c], outside.coefficients().row_scale[c]);
  }
  EXPECT_EQ(inside.nearest(u_x, 7, 4, 7).sphere, 0);
  EXPECT_LT(inside.nearest(u_x, 7, 4, 7).distance, 0.0);
}

}  // namespace
}  // namespace colloid
