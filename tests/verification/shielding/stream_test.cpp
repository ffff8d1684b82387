// Where the stream of a throat carries a colloid between surfaces: see README.md.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/constants.h"
#include "csv_rows.h"
#include "particles/one_way_motion.h"
#include "physics/wall_resistance.h"
#include "scene/read_scene.h"
#include "tiers/inertia_free.h"

namespace colloid {
namespace {

// What point forces and stresslets leave out: stated in shielding.h of the resistance;
// the drive is of the same order.
constexpr double kOfResistance = 0.025;
constexpr double kOfDrive = 0.025;
// Of the velocity along the normal, closer to a grain than half a radius.
constexpr double kAtGrain = 0.08;

Eigen::Vector2d slopes(const Vector3& velocity) {
  return velocity.head<2>() / velocity.z();
}

MobileColloid first() {
  MobileColloid colloid;
  colloid.id = 0;
  return colloid;
}

// In the resolved flow the inlet is a surface that moves with the liquid, which the model
// of one_way does not have: what it would add, alone, to the velocity [mm/s].
Vector3 drag_of_inlet(const Matrix3& resistance, const Vector3& lag,
                      double height_over_radius) {
  const WallResistance w = wall_resistance(height_over_radius - 1.0);
  Matrix3 inlet = (w.f_t - 1.0) * Matrix3::Identity();
  inlet(2, 2) = w.f_n - 1.0;
  return (resistance + inlet).ldlt().solve(inlet * lag);
}

TEST(Shielding, TheStreamCarriesAColloidAsTheResolvedFlow) {
  const Scene scene =
      read_scene(PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json").scene;
  const RunOptions options;
  const InertiaFreeScene throat(scene, options, "one_way");
  const OneWayMotion model(throat.motion_options(true, true), throat.flow,
                           throat.surfaces, throat.grain_radii);
  const double a = throat.radius;
  const double drag = 6.0 * kPi * scene.fluid.viscosity * a;
  int places = 0;
  for (const auto& row : csv_rows("shielding/stream.csv")) {
    const Vec3 x{row[0] * 1e-6, row[1] * 1e-6, row[2] * 1e-6};
    const LinearMotion linear = model.linear({single(first(), x)}, {});
    const Matrix3 resistance = linear.resistance.topLeftCorner<3, 3>() / drag;
    const Vector3 found = resistance.ldlt().solve(linear.drive.head<3>()) / drag * 1e3;
    const Vector3 exact(row[6], row[7], row[8]);
    const Vector3 coarse(row[12], row[13], row[14]);

    // The grid's error falls with its square: that of the fine one is 0.9 of this.
    const double grid_speed = (exact - coarse).norm();
    const double grid_slope = (slopes(exact) - slopes(coarse)).norm();
    const Vector3 inlet =
        drag_of_inlet(resistance, eigen(throat.flow.around(x, a).velocity) * 1e3 - found,
                      (scene.geometry.box.size.z - x.z) / a);
    Vector3 at_grain = Vector3::Zero();
    for (const Sphere& grain : scene.geometry.spheres) {
      const Vector3 apart = eigen(x) - eigen(grain.center);
      if (apart.norm() - grain.radius - a < 0.5 * a) {
        const Vector3 n = apart.normalized();
        at_grain = kAtGrain * exact.dot(n) * n;
      }
    }
    const double speed_error =
        std::hypot(kOfResistance, kOfDrive) * exact.norm() + grid_speed;
    const double slower = speed_error + inlet.norm() + at_grain.norm();
    const double faster = speed_error + at_grain.norm();
    // Two resistances, each of its own error; that of the drive turns it less.
    const double slope_error = std::sqrt(2.0) * kOfResistance * slopes(exact).norm() +
                               grid_slope +
                               (slopes(exact + at_grain) - slopes(exact)).norm();
    const double off = (slopes(found) - slopes(exact)).norm();
    std::printf(
        "%.2f %.2f %.2f um: speed %.4f mm/s, resolved %.4f +- %.4f, from -%.4f to +%.4f; "
        "slopes %.4f %.4f, resolved %.4f %.4f +- %.4f, off by %.4f, at most %.4f\n",
        row[0], row[1], row[2], found.norm(), exact.norm(), grid_speed, slower, faster,
        slopes(found)[0], slopes(found)[1], slopes(exact)[0], slopes(exact)[1],
        grid_slope, off, slope_error);
    EXPECT_GT(found.norm(), exact.norm() - slower);
    EXPECT_LT(found.norm(), exact.norm() + faster);
    EXPECT_LT(off, slope_error);
    EXPECT_LT(grid_slope, 0.01 * slopes(exact).norm());
    ++places;
  }
  EXPECT_EQ(places, 7);
}

}  // namespace
}  // namespace colloid
