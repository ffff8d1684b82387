// A colloid bonded to a held one rolls on it: see README.md beside this file.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "motion_cases.h"
#include "physics/pair_resistance.h"

namespace colloid {
namespace {

using cases::kDrag;
using cases::kRadius;

constexpr double kEdge = 1e-3;
constexpr double kGap = 0.01 * kRadius;
constexpr double kDistance = 2.0 * kRadius + kGap;
constexpr double kLever = kRadius + 0.5 * kGap;
constexpr double kSpeed = 1e-3;
const Vec3 kMiddle{0.5 * kEdge, 0.5 * kEdge, 0.5 * kEdge};

AmbientMotion stream(const Vec3&, double) {
  return {{0.0, 0.0, -kSpeed}, {}};
}

AmbientMotion stream_past(const Vec3& x, double a) {
  return cases::stream_past_sphere({0.0, 0.0, -kSpeed}, a, x - kMiddle, a);
}

// Bonded to retained colloid 7 at `angle` from the upstream pole.
RigidBody bonded_at(double angle) {
  const Vec3 n{std::sin(angle) * 0.6, std::sin(angle) * 0.8, std::cos(angle)};
  RigidBody body = cases::colloid_at(kMiddle + n * kDistance);
  body.bonds.push_back({0, {SurfaceId::Kind::colloid, 7}, kMiddle, kDistance});
  return body;
}

double angle_of(const RigidBody& body) {
  const Vec3 e = body.centre - kMiddle;
  return std::atan2(std::hypot(e.x, e.y), e.z);
}

OneWayOptions options(bool hindrance) {
  OneWayOptions out = cases::free_of_hindrance(kGap);
  out.wall_hindrance = hindrance;
  return out;
}

void expect_rolling(const RigidBody& body, const Box& box) {
  EXPECT_NEAR(norm(body.centre - kMiddle), kDistance, 1e-9 * kRadius);
  const Vec3 contact = bond_contact(body, body.bonds[0], box, kRadius);
  EXPECT_LT(norm(body.velocity + cross(body.spin, contact)), 1e-12 * kSpeed);
}

// Balance of torques about the point of contact, over 6 pi mu a^2 (lengths over a): the
// stream's torque per speed U_t along the surface, and the resistance to rolling w.
struct RollingBalance {
  double drive = 0.0;
  double resistance = 0.0;
};

// Each by itself: l against l^2 + 4/3.
RollingBalance balance_without_hindrance(double lever) {
  return {lever, lever * lever + 4.0 / 3.0};
}

// Jeffrey & Onishi's functions of two equal spheres: held in a stream U_t both feel what
// they feel moving as one.  (StreamPastSphere, which the code uses, takes no part.)
RollingBalance balance_with_hindrance(double lever) {
  const PairResistance r = TwoSphereResistance(1.0).at(kGap / kRadius);
  return {lever * (r.ya11 + r.ya12) + 2.0 / 3.0 * (r.yb11 + r.yb12),
          r.ya11 * lever * lever + 4.0 / 3.0 * (r.yb11 * lever + r.yc11)};
}

// The centre goes round at w l: d angle/dt = k sin(angle), so tan(angle/2) grows like
// exp(k t).
void expect_time_of_balance(const OneWayOptions& given, cases::GivenFlow::Formula flow,
                            const RollingBalance& balance, double precision) {
  const double lever = kLever / kRadius;
  const double k = kSpeed / kDistance * lever * balance.drive / balance.resistance;
  double last = 0.0;
  for (double tolerance : {1e-3, 1e-5}) {
    cases::Setting setting(given, flow, cases::wide_box(kEdge), {});
    setting.surfaces.add_colloid(7, {kMiddle, kRadius});
    Integrator integrator = setting.integrator(tolerance);
    std::vector<RigidBody> bodies{bonded_at(0.2)};
    double time = 0.0;
    double worst = 0.0;
    while (time * k < 8.0) {
      time += integrator.advance(bodies, 0.5 / k, std::nullopt);
      const double expected = 2.0 * std::atan(std::tan(0.1) * std::exp(k * time));
      worst = std::max(worst, std::abs(angle_of(bodies[0]) - expected));
      expect_rolling(bodies[0], setting.surfaces.box());
    }
    std::printf("tolerance %g: angle off by %.1e, %ld steps, k D/U = %.4f\n", tolerance,
                worst, integrator.counts().steps, k * kDistance / kSpeed);
    // At most `tolerance` a/D per step, which grows with the angle itself, by
    // 1/sin(0.2) at most, five; a relative error of k shifts the angle by as much times
    // k t sin(angle), three at most.
    EXPECT_LT(worst, 2.5 * tolerance * static_cast<double>(integrator.counts().steps) +
                         3.0 * precision);
    if (last > 10.0 * precision) {
      EXPECT_LT(worst, 0.2 * last);
    }
    last = worst;
    // At rest behind the sphere.
    EXPECT_GT(angle_of(bodies[0]), kPi - 0.01);
    EXPECT_LT(norm(bodies[0].velocity), 0.01 * kSpeed);
  }
}

TEST(Rolling, TakesTheTimeOfItsBalanceWithoutHindrance) {
  expect_time_of_balance(options(false), stream,
                         balance_without_hindrance(kLever / kRadius), 1e-8);
}

// The fits of Y11 and Y12 are good to 3e-5 each, and Y11 + Y12 is a third of Y11.
TEST(Rolling, TakesTheTimeOfItsBalanceWithHindrance) {
  expect_time_of_balance(options(true), stream_past,
                         balance_with_hindrance(kLever / kRadius), 3e-4);
}

// Behind the sphere the bond carries the whole drag, pulling against the flow.
TEST(Rolling, BondCarriesTheDragAtTheRear) {
  cases::Setting setting(options(false), stream, cases::wide_box(kEdge), {});
  setting.surfaces.add_colloid(7, {kMiddle, kRadius});
  const Motion motion = setting.model->motion({bonded_at(kPi)}, {}, {});
  EXPECT_NEAR(motion.bond_wrench[0].force.z / (kDrag * kSpeed), 1.0, 1e-12);
  EXPECT_LT(norm(motion.velocity[0]), 1e-12 * kSpeed);
}

// Two bonds leave one turn, about the line through both contacts; three none.
TEST(Rolling, BondsLeaveTheMotionsTheyShould) {
  std::vector<Vector3> contacts{{1.0, 0.0, 0.0}};
  EXPECT_EQ(motions_at_rest(contacts).cols(), 3);
  contacts.push_back({0.0, 1.0, 0.0});
  const auto motions = motions_at_rest(contacts);
  ASSERT_EQ(motions.cols(), 1);
  for (const Vector3& c : contacts) {
    const Vector3 w = motions.col(0).tail<3>();
    const Vector3 point = motions.col(0).head<3>() + w.cross(c);
    EXPECT_LT(point.norm(), 1e-14);
  }
  contacts.push_back({0.0, 0.0, -1.0});
  EXPECT_EQ(motions_at_rest(contacts).cols(), 0);
  // Three in a line still let it turn.
  EXPECT_EQ(motions_at_rest({{1.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.0, 1.0, 0.0}}).cols(),
            1);
}

}  // namespace
}  // namespace colloid
