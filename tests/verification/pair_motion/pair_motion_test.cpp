// Two mobile colloids: see README.md beside this file.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "motion_cases.h"
#include "physics/pair_in_strain.h"

namespace colloid {
namespace {

using cases::kDrag;
using cases::kRadius;

constexpr double kEdge = 1e-3;
const Vec3 kMiddle{0.5 * kEdge, 0.5 * kEdge, 0.5 * kEdge};

OneWayOptions pair_options(double gap) {
  OneWayOptions options = cases::free_of_hindrance(gap);
  options.pair_hindrance = true;
  options.rules.colloids_attach = false;
  return options;
}

// Two colloids at middle +- r/2.
std::vector<RigidBody> pair_at(const Vec3& r) {
  return {cases::colloid_at(kMiddle + 0.5 * r, 0),
          cases::colloid_at(kMiddle - 0.5 * r, 1)};
}

struct Squeeze {
  double distance;  // over a
  double factor;    // force over 6 pi mu a U
};

// Stimson & Jeffery's problem with opposed velocities; digits of an independent sum.
TEST(TwoColloids, ApproachUnderOpposedForces) {
  const cases::Setting setting(pair_options(1e-4 * kRadius), cases::at_rest,
                               cases::wide_box(kEdge), {});
  const Vec3 n{0.48, -0.6, 0.64};
  for (const Squeeze& s :
       {Squeeze{2.01, 53.4223}, Squeeze{2.1, 7.41330}, Squeeze{3.0, 2.03865}}) {
    const double force = 1e-13;
    const Motion motion = setting.model->motion(pair_at(n * (s.distance * kRadius)), {},
                                                {{n * -force, {}}, {n * force, {}}});
    const Vec3 expected = n * (-force / kDrag / s.factor);
    // The fit of the pair functions: 3e-5 of the larger one.
    EXPECT_LT(norm(motion.velocity[0] - expected), 1e-4 * norm(expected)) << s.distance;
    EXPECT_LT(norm(motion.velocity[1] + expected), 1e-4 * norm(expected)) << s.distance;
  }
}

// Far enough apart they do not feel each other; the weight falls to zero at four radii.
TEST(TwoColloids, DoNotFeelEachOtherFarApart) {
  const cases::Setting setting(pair_options(1e-4 * kRadius), cases::at_rest,
                               cases::wide_box(kEdge), {});
  const Vec3 n{0.0, 0.0, 1.0};
  const Motion motion = setting.model->motion(pair_at(n * (6.01 * kRadius)), {},
                                              {{n * -kDrag, {}}, {n * kDrag, {}}});
  EXPECT_NEAR(motion.velocity[0].z, -1.0, 1e-14);
}

// A general linear flow E.x + w x (x - middle) [1/s].
AmbientMotion linear_flow(const Vec3& x, double) {
  const Vec3 y = x - kMiddle;
  const Vec3 strain{0.7 * y.x + 0.4 * y.y - 0.2 * y.z, 0.4 * y.x + 0.1 * y.y + 0.3 * y.z,
                    -0.2 * y.x + 0.3 * y.y - 0.8 * y.z};
  const Vec3 spin{0.3, -0.5, 0.2};
  return {strain + cross(spin, y), spin};
}

// Batchelor & Green (1972): V = w x r + E.r - [A nn + B (I - nn)].E.r, the force-free
// pair; A and B from their own series, through another code path (PairInStrain).
TEST(TwoColloids, FollowALinearFlowAsBatchelorAndGreen) {
  const cases::Setting setting(pair_options(1e-5 * kRadius), linear_flow,
                               cases::wide_box(kEdge), {});
  const PairInStrain series;
  for (const Vec3& n :
       {Vec3{0.48, -0.6, 0.64}, Vec3{1.0, 0.0, 0.0}, Vec3{-0.36, 0.48, 0.8}}) {
    for (double gap : {1e-3, 1e-2, 0.1, 0.5, 1.0, 2.0}) {
      const Vec3 r = n * ((2.0 + gap) * kRadius);
      const Motion motion = setting.model->motion(pair_at(r), {}, {});
      const Vec3 spin{0.3, -0.5, 0.2};
      const Vec3 er = linear_flow(kMiddle + r, 0.0).velocity - cross(spin, r);
      const StrainHindrance f = series.at(gap);
      const Vec3 along = n * dot(er, n);
      const Vec3 expected = cross(spin, r) + er - along * f.a - (er - along) * f.b;
      const Vec3 relative = motion.velocity[0] - motion.velocity[1];
      EXPECT_LT(norm(relative - expected), 1e-12 * kRadius) << gap;
      EXPECT_LT(norm(motion.velocity[0] + motion.velocity[1]), 1e-12 * kRadius);
    }
  }
}

// Far-field expansion of A and B as Batchelor & Green print it: tests the reference.
TEST(TwoColloids, SeriesOfTheReferenceHasThePublishedFarField) {
  const PairInStrain series;
  for (double s : {8.0, 12.0, 20.0}) {
    const StrainHindrance f = series.at(s - 2.0);
    const double a = 5.0 / std::pow(s, 3) - 8.0 / std::pow(s, 5) + 25.0 / std::pow(s, 6);
    EXPECT_NEAR(f.a, a, 40.0 / std::pow(s, 8));
    EXPECT_NEAR(f.b, 16.0 / (3.0 * std::pow(s, 5)), 60.0 / std::pow(s, 8));
  }
}

AmbientMotion shear(const Vec3& x, double) {
  return {{x.z - kMiddle.z, 0.0, 0.0}, {0.0, 0.5, 0.0}};
}

// Separation of two spheres in the shear u_x = z (rate 1), in the plane of shear:
// Batchelor & Green's V integrated by the classical Runge-Kutta method in steps that
// shrink with the gap.  Shares A, B and the weight with the code, not the mechanics.
struct Passing {
  double least_gap = 1e9;  // over a
  double end_x = 0.0, end_z = 0.0;
};
Passing exact_passing(double x0, double z0, double step) {
  const PairInStrain series;
  Passing out;
  const auto rate = [&](double x, double z, double& vx, double& vz) {
    const double s = std::hypot(x, z);
    const double w = hindrance_weight(s - 2.0);
    const StrainHindrance f = series.at(s - 2.0);
    const double nx = x / s, nz = z / s;
    // E.r = (z, x)/2, w x r = (z, -x)/2.
    const double ex = 0.5 * z, ez = 0.5 * x;
    const double en = ex * nx + ez * nz;
    vx = 0.5 * z + ex - w * (f.a * en * nx + f.b * (ex - en * nx));
    vz = -0.5 * x + ez - w * (f.a * en * nz + f.b * (ez - en * nz));
  };
  double x = x0, z = z0;
  while (x < -x0) {
    const double gap = std::hypot(x, z) - 2.0;
    out.least_gap = std::min(out.least_gap, gap);
    const double h = step * std::min(1.0, std::max(gap, 1e-3));
    double ax, az, bx, bz, cx, cz, dx, dz;
    rate(x, z, ax, az);
    rate(x + 0.5 * h * ax, z + 0.5 * h * az, bx, bz);
    rate(x + 0.5 * h * bx, z + 0.5 * h * bz, cx, cz);
    rate(x + h * cx, z + h * cz, dx, dz);
    x += h / 6.0 * (ax + 2.0 * bx + 2.0 * cx + dx);
    z += h / 6.0 * (az + 2.0 * bz + 2.0 * cz + dz);
  }
  out.end_x = x;
  out.end_z = z;
  return out;
}

TEST(TwoColloids, PassInShearOnTheExactTrajectory) {
  const cases::Setting setting(pair_options(1e-5 * kRadius), shear,
                               cases::wide_box(kEdge), {});
  for (double offset : {1.0, 0.6}) {
    constexpr double kFrom = -8.0;
    const Passing exact = exact_passing(kFrom, offset, 4e-3);
    const Passing coarser = exact_passing(kFrom, offset, 8e-3);
    ASSERT_NEAR(coarser.least_gap / exact.least_gap, 1.0, 1e-6);
    double last = 0.0;
    for (double tolerance : {1e-3, 1e-4, 1e-5}) {
      Integrator integrator = setting.integrator(tolerance, 0.1);
      std::vector<RigidBody> bodies = pair_at(Vec3{kFrom, 0.0, offset} * kRadius);
      double least = 1e9;
      Vec3 r;
      do {
        integrator.advance(bodies, 1.0, std::nullopt);
        r = (bodies[0].centre - bodies[1].centre) * (1.0 / kRadius);
        least = std::min(least, norm(r) - 2.0);
      } while (r.x < -kFrom);
      const double gap_error = std::abs(least / exact.least_gap - 1.0);
      const double height_error = std::abs(r.z - offset);
      std::printf(
          "offset %g, tolerance %g: least gap %.4e (exact %.4e), height after "
          "%.5f, %ld steps\n",
          offset, tolerance, least, exact.least_gap, r.z, integrator.counts().steps);
      // README: a relative error of `tolerance` per step while the gap is small, and
      // what lies between steps at the least gap, 1e-3 of it.
      EXPECT_LT(gap_error,
                tolerance * static_cast<double>(integrator.counts().steps) + 3e-3);
      // Reversible: the same height after as before, and fore-aft symmetric.
      EXPECT_LT(height_error,
                3.0 * tolerance * static_cast<double>(integrator.counts().steps));
      EXPECT_NEAR(exact.end_z, offset, 1e-4);
      if (last > 1e-3) {
        EXPECT_LT(height_error, 0.5 * last);
      }
      last = height_error;
    }
  }
}

}  // namespace
}  // namespace colloid
