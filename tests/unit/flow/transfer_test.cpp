#include "flow/transfer.h"

#include <gtest/gtest.h>

#include "flow/halo.h"

namespace colloid {
namespace {

FlowFaces all(FlowFace::Kind kind) {
  FlowFaces faces;
  for (FlowFace& f : faces) {
    f.kind = kind;
  }
  return faces;
}

// Levels without spheres, even and odd numbers of cells.
struct Levels {
  Levels(const std::array<int, 3>& cells, FlowFace::Kind kind)
      : periodic(kind == FlowFace::Kind::periodic),
        fine(make_grid({1.0 * cells[0], 1.0 * cells[1], 1.0 * cells[2]}, cells,
                       {periodic, periodic, periodic}),
             all(kind)),
        coarse(coarsen(fine.grid(), {true, true, true}), all(kind)),
        transfer(make_transfer(fine.grid(), coarse.grid(), fine.axes())) {}
  bool periodic;
  WallRows fine;
  WallRows coarse;
  LevelTransfer transfer;
};

template <class Visit>
void for_unknowns(const WallRows& rows, int component, const Visit& visit) {
  const Grid& grid = rows.grid();
  for (int k = 0; k < grid.end(component, 2); ++k) {
    for (int j = 0; j < grid.end(component, 1); ++j) {
      for (int i = 0; i < grid.end(component, 0); ++i) {
        const std::size_t q = grid.index(i, j, k);
        const bool open =
            component == pressure
                ? rows.coefficients().cell_scale[q] > 0.0F
                : rows.coefficients().row_scale[static_cast<std::size_t>(component)][q] >
                      0.0F;
        if (open) {
          visit(q, grid.location(component, i, j, k));
        }
      }
    }
  }
}

TEST(Transfer, ConstantsPassBothWaysInAPeriodicBox) {
  for (const auto& cells : {std::array<int, 3>{8, 6, 10}, std::array<int, 3>{9, 7, 5},
                            std::array<int, 3>{40, 3, 2}}) {
    const Levels levels(cells, FlowFace::Kind::periodic);
    StokesVector<float> up(levels.coarse.grid().size), down(levels.fine.grid().size);
    StokesVector<float> r(levels.fine.grid().size), f(levels.coarse.grid().size);
    for (int c = 0; c < 4; ++c) {
      for_unknowns(levels.coarse, c,
                   [&](std::size_t q, const Vec3&) { up[c][q] = 2.0F; });
      for_unknowns(levels.fine, c, [&](std::size_t q, const Vec3&) { r[c][q] = 3.0F; });
      fill_halo(levels.coarse.grid(), up[c]);
      fill_halo(levels.fine.grid(), r[c]);
    }
    const LevelView fine = view(levels.fine);
    const LevelView coarse = view(levels.coarse);
    for (int k = 0; k < fine.end[2]; ++k) {
      prolong_plane(levels.transfer, fine, coarse, up, down, k);
    }
    for (int k = 0; k < coarse.end[2]; ++k) {
      restrict_plane(levels.transfer, fine, coarse, r, f, k);
    }
    for (int c = 0; c < 4; ++c) {
      for_unknowns(levels.fine, c, [&](std::size_t q, const Vec3&) {
        EXPECT_NEAR(down[c][q], 2.0F, 1e-6) << "component " << c;
      });
      for_unknowns(levels.coarse, c, [&](std::size_t q, const Vec3&) {
        EXPECT_NEAR(f[c][q], 3.0F, 1e-6) << "component " << c;
      });
    }
  }
}

// Between walls a velocity that is linear in the distance from one of them is
// interpolated exactly there: the wall's own value takes part.
TEST(Transfer, LinearVelocityBesideAWallIsExact) {
  const Levels levels({8, 8, 7}, FlowFace::Kind::velocity);
  StokesVector<float> up(levels.coarse.grid().size), down(levels.fine.grid().size);
  for_unknowns(levels.coarse, u_x, [&](std::size_t q, const Vec3& x) {
    up[u_x][q] = static_cast<float>(x.y);
  });
  const LevelView fine = view(levels.fine);
  const LevelView coarse = view(levels.coarse);
  for (int k = 0; k < fine.end[2]; ++k) {
    prolong_plane(levels.transfer, fine, coarse, up, down, k);
  }
  for_unknowns(levels.fine, u_x, [&](std::size_t q, const Vec3& x) {
    // Away from the faces where another wall's zero pulls the value down.
    if (x.x > 1.5 && x.x < 6.5 && x.z > 1.5 && x.z < 5.5 && x.y < 6.0) {
      EXPECT_NEAR(down[u_x][q], x.y, 1e-5);
    }
  });
}

}  // namespace
}  // namespace colloid
