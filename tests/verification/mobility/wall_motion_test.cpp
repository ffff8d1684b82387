// A sphere beside a plane wall, by every motion: see README.md beside this file.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "body_cases.h"
#include "physics/wall_resistance.h"

namespace colloid {
namespace {

using cases::kBodyDrag;
using cases::kBodyRadius;
using cases::kBodyTurn;

// The thorough program is `ctest -L long`.
#ifdef PORECLOG_THOROUGH
const std::vector<double> kWide{1.0, 0.5431};
const std::vector<double> kNarrow{0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01};
#else
const std::vector<double> kWide{1.0};
const std::vector<double> kNarrow{0.1, 0.01};
#endif

// Mobility of a sphere beside the wall z = 0 of a cube, in Stokes' units, at `cells` per
// radius: speeds of a sphere that a force or torque moves, or that the shear carries.
struct Motions {
  double away;         ///< from the wall, by a force along the normal
  double along;        ///< by a force along the wall
  double along_spin;   ///< spin of that, times the radius
  double turning;      ///< by a torque about an axis along the wall
  double shear_speed;  ///< over that of the shear at the centre
  double shear_spin;   ///< over half the shear
};

Motions exact_motions(double gap) {
  const WallResistance w = wall_resistance(gap);
  const FreeMotion shear = free_in_shear(gap);
  // (R1): F/(6 pi mu a) = f_t U - 4/3 t_t a w, T/(8 pi mu a^2) = -t_t U + t_r a w.
  const double determinant = w.f_t * w.t_r - 4.0 / 3.0 * w.t_t * w.t_t;
  return {1.0 / w.f_n,         w.t_r / determinant, w.t_t / determinant,
          w.f_t / determinant, shear.speed,         shear.spin};
}

// A sphere `gap` above the wall z = 0 of a cube, off every symmetry of the grid along it.
Scene beside_wall(int cells, int extent, double gap, Lubrication lubrication) {
  const double cell = kBodyRadius / cells;
  const double middle = 0.5 * extent * kBodyRadius;
  Scene scene = cases::cube_of_liquid(extent, FaceCondition::wall, FaceCondition::wall,
                                      FaceCondition::wall);
  scene.fidelity.lubrication = lubrication;
  cases::add_body(
      scene, {middle + 0.37 * cell, middle + 0.22 * cell, (1.0 + gap) * kBodyRadius});
  return scene;
}

BodyMeasurement moved(Scene& scene, int cells, const Vec3& force, const Vec3& torque) {
  scene.geometry.bodies[0].force = force;
  scene.geometry.bodies[0].torque = torque;
  return cases::measured(scene, cells).bodies[0];
}

constexpr double kSpeed = 1e-3;  // Stokes' under the load [m/s]

using Pushed = std::array<double, 2>;  // along, its spin
Pushed pushed_along(int cells, int extent, double gap, Lubrication lubrication) {
  Scene scene = beside_wall(cells, extent, gap, lubrication);
  const BodyMeasurement body = moved(scene, cells, {kBodyDrag * kSpeed, 0, 0}, {});
  return {body.velocity.x / kSpeed, body.spin.y * kBodyRadius / kSpeed};
}

using Others = std::array<double, 4>;  // away, turning, shear speed, shear spin
Others other_motions(int cells, int extent, double gap, Lubrication lubrication) {
  Scene scene = beside_wall(cells, extent, gap, lubrication);
  Others out{};
  out[0] = moved(scene, cells, {0, 0, kBodyDrag * kSpeed}, {}).velocity.z / kSpeed;
  const double torque = kBodyTurn * kSpeed / kBodyRadius;
  out[1] = moved(scene, cells, {}, {0, torque, 0}).spin.y * kBodyRadius / kSpeed;
  scene.geometry.box.faces = {FaceCondition::periodic, FaceCondition::periodic,
                              FaceCondition::periodic, FaceCondition::periodic,
                              FaceCondition::wall,     FaceCondition::wall};
  scene.drive.shear_rate = 100.0;
  const BodyMeasurement carried = moved(scene, cells, {}, {});
  out[2] = carried.velocity.x / (100.0 * scene.geometry.bodies[0].sphere.center.z);
  out[3] = carried.spin.y / 50.0;
  return out;
}

// What is beyond a small cube, from a larger one, twice as wide, where walls far away act
// like 1/L^power.
double beyond(double small, double large, double power) {
  return (large - small) * (1.0 + 1.0 / (std::pow(2.0, power) - 1.0));
}

// What a half-space would give.  The far walls' part is found on coarse grids.  A force
// along the wall reaches far: cubes of 16 and 32 radii, else 8 and 16.  All act like
// 1/L^3, but along the normal like 1/L^5 (Blake 1971).
Motions in_half_space(int cells, double gap, Lubrication lubrication) {
  const Pushed near = pushed_along(2, 16, gap, lubrication);
  const Pushed far = pushed_along(2, 32, gap, lubrication);
  const Pushed along = pushed_along(cells, 16, gap, lubrication);
  constexpr int kCoarse = 3;
  const Others small = other_motions(kCoarse, 8, gap, lubrication);
  const Others large = other_motions(kCoarse, 16, gap, lubrication);
  const Others found =
      cells == kCoarse ? small : other_motions(cells, 8, gap, lubrication);
  return {found[0] + beyond(small[0], large[0], 5.0),
          along[0] + beyond(near[0], far[0], 3.0),
          along[1] + beyond(near[1], far[1], 3.0),
          found[1] + beyond(small[1], large[1], 3.0),
          found[2] + beyond(small[2], large[2], 3.0),
          found[3] + beyond(small[3], large[3], 3.0)};
}

std::array<double, 6> listed(const Motions& m) {
  return {m.away, m.along, m.along_spin, m.turning, m.shear_speed, m.shear_spin};
}
constexpr std::array<const char*, 6> kNames{"away",    "along",       "spin of along",
                                            "turning", "shear speed", "shear spin"};

// The spin that comes with a motion along the wall is small: compared with the motion.
void expect_close(const Motions& found, double gap, double bound, int cells) {
  const auto have = listed(found);
  const auto want = listed(exact_motions(gap));
  for (std::size_t n = 0; n < 6; ++n) {
    const double scale = n == 2 ? want[1] : want[n];
    std::printf("gap %5g a, %2d cells/d, %-13s %8.5f  exact %8.5f  %+.2f %%\n", gap,
                2 * cells, kNames[n], have[n], want[n],
                100.0 * (have[n] - want[n]) / scale);
    EXPECT_NEAR((have[n] - want[n]) / scale, 0.0, bound) << kNames[n] << " at " << gap;
  }
}

// The grid alone, gaps above a cell: 1 % at 12 cells per diameter; at 8 what a method of
// second order makes of that.
TEST(WallMotion, WideGapsAreResolved) {
  for (double gap : kWide) {
    for (const auto& [cells, bound] : {std::pair{4, 0.0225}, std::pair{6, 0.01}}) {
      expect_close(in_half_space(cells, gap, Lubrication::resolved_only), gap, bound,
                   cells);
    }
  }
}

// With what the grid leaves out: 5 % down to a hundredth of the radius, at 10 and 12
// cells per diameter.  At 8 some motions are further off (README.md).
TEST(WallMotion, LubricationCompletesNarrowGaps) {
  for (double gap : kNarrow) {
    for (int cells : {5, 6}) {
      expect_close(in_half_space(cells, gap, Lubrication::full), gap, 0.05, cells);
    }
  }
}

// Lubrication that is counted where the grid resolves the gap already would show here.
TEST(WallMotion, LubricationLeavesWideGapsAlone) {
  const Others bare = other_motions(4, 8, 1.0, Lubrication::resolved_only);
  const Others full = other_motions(4, 8, 1.0, Lubrication::full);
  for (std::size_t n = 0; n < bare.size(); ++n) {
    EXPECT_NEAR(full[n] / bare[n], 1.0, 0.005) << n;
  }
}

}  // namespace
}  // namespace colloid
