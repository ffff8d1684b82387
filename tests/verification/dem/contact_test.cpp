// Impacts of a colloid.
// Reference  Hertz (physics of elastic spheres): largest overlap (15 m v^2/(16 E sqrt
// R))^0.4,
//            duration 2.868 (m^2/(R E^2 v))^0.2, with the reduced m, R, E of the pair;
//            Coulomb: a sphere that slides throughout loses mu (1 + e) v_n along the
//            surface and gains the spin 5/2 mu (1 + e) v_n / a.
// Tolerance  leapfrog is of second order: with p = pi step / duration, the phase of a
//            sub-step, a harmonic spring's period is off by p^2/24.  The stiffness here
//            grows with the overlap (by 3/2 at its largest over its mean), so p^2/10.
//            Damping sees the velocity half a sub-step late: ln(e) to p/2 of itself.
//            Friction follows the normal force, p^2/2.
#include <functional>

#include <gtest/gtest.h>

#include "dem_case.h"

namespace colloid::dem_test {
namespace {

struct Impact {
  double overlap = 0.0;
  double duration = 0.0;
  DemState after;  ///< of the colloid 0
};

/// Sub-step by sub-step until the surfaces part; `gap` of the states.
Impact follow(Dem& dem, double step,
              const std::function<double(const std::vector<DemState>&)>& gap) {
  double entered = 0.0;
  double deepest = 0.0;
  std::vector<double> gaps{gap(dem.states())};
  for (int i = 1; i < 20000; ++i) {
    dem.advance(step, {});
    const double before = gaps.back();
    gaps.push_back(gap(dem.states()));
    const double now = gaps.back();
    const auto n = gaps.size();
    if (before > 0.0 && now <= 0.0) {  // free flight up to here
      const double speed = (gaps[n - 3] - before) / step;
      entered = step * (i - 1) + before / speed;
    }
    if (n > 2 && before < 0.0 && before <= gaps[n - 3] && before <= now) {
      const double slope = 0.5 * (now - gaps[n - 3]);
      const double curvature = now - 2.0 * before + gaps[n - 3];
      deepest = before - 0.5 * slope * slope / curvature;
    }
    if (before < 0.0 && now > 0.0) {
      dem.advance(step, {});
      const std::vector<DemState> states = dem.states();
      const double speed = (gap(states) - now) / step;
      return {-deepest, step * i - now / speed - entered, states.at(0)};
    }
  }
  ADD_FAILURE() << "the colloid does not come back";
  return {};
}

struct Hertz {
  double mass, radius, modulus, speed;
  double overlap() const {
    return std::pow(15.0 * mass * speed * speed / (16.0 * modulus * std::sqrt(radius)),
                    0.4);
  }
  double duration() const {
    return 2.868 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2);
  }
};

double plane_strain(double young) {
  return young / (1.0 - kPoisson * kPoisson);
}

constexpr double kImpactSpeed = 1e-2;  // [m/s]
constexpr double kGrainRadius = 48.3e-6;

void expect_hertz(const Impact& impact, const Hertz& hertz, double step) {
  const double phase = kPi * step / hertz.duration();
  const double tolerance = phase * phase / 10.0;
  EXPECT_NEAR(impact.overlap / hertz.overlap(), 1.0, tolerance) << step;
  EXPECT_NEAR(impact.duration / hertz.duration(), 1.0, tolerance) << step;
}

TEST(DemContact, OfTwoColloidsIsHertz) {
  for (const double step : {5e-8, 2.5e-8}) {
    DemOptions options = inert();
    options.restitution = 1.0;
    options.step = step;
    Dem dem(options, {});
    const Vec3 apart{kRadius + 3.3e-9, 0.0, 0.0};
    dem.add({0, kMiddle - apart, {0.5 * kImpactSpeed, 0.0, 0.0}, {}});
    dem.add({1, kMiddle + apart, {-0.5 * kImpactSpeed, 0.0, 0.0}, {}});
    const Impact impact = follow(dem, step, [](const std::vector<DemState>& s) {
      return norm(s.at(0).position - s.at(1).position) - 2.0 * kRadius;
    });
    expect_hertz(impact,
                 {0.5 * kMass, 0.5 * kRadius, 0.5 * plane_strain(kModulus), kImpactSpeed},
                 step);
  }
}

TEST(DemContact, WithAGrainIsHertz) {
  const double stiff = plane_strain(20e9);
  const double soft = plane_strain(kModulus);
  for (const double step : {5e-8, 2.5e-8}) {
    DemOptions options = inert();
    options.restitution = 1.0;
    options.step = step;
    Dem dem(options, {{kMiddle, kGrainRadius}});
    dem.add({0,
             kMiddle + Vec3{0.0, 0.0, kGrainRadius + kRadius + 3.3e-9},
             {0.0, 0.0, -kImpactSpeed},
             {}});
    const Impact impact = follow(dem, step, [](const std::vector<DemState>& s) {
      return norm(s.at(0).position - kMiddle) - kRadius - kGrainRadius;
    });
    expect_hertz(impact,
                 {kMass, kRadius * kGrainRadius / (kRadius + kGrainRadius),
                  soft * stiff / (soft + stiff), kImpactSpeed},
                 step);
  }
}

TEST(DemContact, WithARetainedColloidIsThatWithAnImmovableOne) {
  DemOptions options = inert();
  options.restitution = 1.0;
  Dem dem(options, {});
  dem.add({0,
           kMiddle + Vec3{0.0, 2.0 * kRadius + 3.3e-9, 0.0},
           {0.0, -kImpactSpeed, 0.0},
           {}});
  dem.add({1, kMiddle, {}, {}, true});
  const Impact impact = follow(dem, options.step, [](const std::vector<DemState>& s) {
    return norm(s.at(0).position - s.at(1).position) - 2.0 * kRadius;
  });
  expect_hertz(impact, {kMass, 0.5 * kRadius, 0.5 * plane_strain(kModulus), kImpactSpeed},
               options.step);
  EXPECT_EQ(dem.states().at(1).position, kMiddle);
}

/// Onto the wall z- at 1 cm/s, and `along` it.
Impact onto_wall(DemOptions options, double along) {
  Dem dem(options, {});
  dem.add({0, {1e-4, 1e-4, kRadius + 3.3e-9}, {along, 0.0, -kImpactSpeed}, {}});
  return follow(dem, options.step, [](const std::vector<DemState>& s) {
    return s.at(0).position.z - kRadius;
  });
}

double wall_phase(double step) {
  const double stiff = plane_strain(20e9);
  const double soft = plane_strain(kModulus);
  const Hertz hertz{kMass, kRadius, soft * stiff / (soft + stiff), kImpactSpeed};
  return kPi * step / hertz.duration();
}

TEST(DemContact, ReturnsTheFractionOfRestitution) {
  for (const double step : {5e-8, 2.5e-8}) {
    for (const double restitution : {0.9, 0.5}) {
      DemOptions options = inert();
      options.restitution = restitution;
      options.step = step;
      const Impact impact = onto_wall(options, 0.0);
      EXPECT_NEAR(
          std::log(impact.after.velocity.z / kImpactSpeed) / std::log(restitution), 1.0,
          0.5 * wall_phase(step))
          << restitution;
      EXPECT_EQ(impact.after.velocity.x, 0.0);
      EXPECT_EQ(impact.after.position.x, 1e-4);
    }
  }
}

TEST(DemContact, ReturnsTheSameFromARetainedColloid) {
  const Vec3 grain = kMiddle - Vec3{0.0, 0.0, kGrainRadius + kRadius};
  for (const bool arrested : {true, false}) {
    DemOptions options = inert();
    options.surfaces.rules.grains_attach = true;
    Dem dem(options, {{grain, kGrainRadius}});
    dem.add({1, kMiddle, {}, {}, !arrested});
    dem.advance(options.step, {});  // it touches the grain
    ASSERT_TRUE(dem.states().at(0).held);
    dem.add({0,
             kMiddle + Vec3{0.0, 0.0, 2.0 * kRadius + 3.3e-9},
             {0.0, 0.0, -kImpactSpeed},
             {}});
    const Impact impact = follow(dem, options.step, [](const std::vector<DemState>& s) {
      return norm(s.at(0).position - s.at(1).position) - 2.0 * kRadius;
    });
    EXPECT_NEAR(
        std::log(impact.after.velocity.z / kImpactSpeed) / std::log(options.restitution),
        1.0, 0.5 * wall_phase(options.step));
  }
}

TEST(DemContact, SlidesByCoulombsFriction) {
  for (const double step : {5e-8, 2.5e-8}) {
    DemOptions options = inert();
    options.restitution = 1.0;
    options.step = step;
    const double along = 4.0 * kImpactSpeed;
    const Impact impact = onto_wall(options, along);
    const double lost = options.friction * 2.0 * kImpactSpeed;
    const double phase = wall_phase(step);
    EXPECT_NEAR((along - impact.after.velocity.x) / lost, 1.0, 0.5 * phase * phase);
    EXPECT_NEAR(impact.after.spin.y / (2.5 * lost / kRadius), 1.0, 0.5 * phase * phase);
    EXPECT_EQ(impact.after.velocity.y, 0.0);
  }
}

TEST(DemContact, InletAndSymmetryHoldBackWithoutFriction) {
  DemOptions options = inert();
  options.restitution = 1.0;
  for (const FaceCondition condition : {FaceCondition::symmetry, FaceCondition::inlet}) {
    options.box.faces[z_minus] = condition;
    const Impact impact = onto_wall(options, 4.0 * kImpactSpeed);
    EXPECT_NEAR(impact.after.velocity.z, kImpactSpeed, 1e-3 * kImpactSpeed);
    EXPECT_EQ(impact.after.velocity.x, 4.0 * kImpactSpeed);
    EXPECT_EQ(impact.after.spin.y, 0.0);
  }
}

TEST(DemContact, OutletLetsThrough) {
  DemOptions options = inert();
  options.box.faces[z_minus] = FaceCondition::outlet;
  Dem dem(options, {});
  dem.add({0, {1e-4, 1e-4, kRadius}, {0.0, 0.0, -kImpactSpeed}, {}});
  dem.advance(1e-5, {});
  EXPECT_NEAR(dem.states().at(0).position.z, kRadius - 1e-7, 1e-18);
  dem.remove(0);
  EXPECT_TRUE(dem.states().empty());
}

TEST(DemContact, ActsThroughPeriodicFaces) {
  DemOptions options = inert();
  options.restitution = 1.0;
  options.box.faces[x_minus] = options.box.faces[x_plus] = FaceCondition::periodic;
  Dem dem(options, {});
  dem.add({0, {kRadius - 1e-9, 1e-4, 1e-4}, {-0.5 * kImpactSpeed, 0.0, 0.0}, {}});
  dem.add({1, {2e-4 - kRadius - 4e-9, 1e-4, 1e-4}, {0.5 * kImpactSpeed, 0.0, 0.0}, {}});
  dem.advance(5e-6, {});
  const std::vector<DemState> after = dem.states();
  // They exchange their velocities; energy to the order of the leapfrog.
  EXPECT_NEAR(after.at(0).velocity.x, 0.5 * kImpactSpeed, 1e-2 * kImpactSpeed);
  EXPECT_NEAR(after.at(0).velocity.x + after.at(1).velocity.x, 0.0, 1e-14);
}

}  // namespace
}  // namespace colloid::dem_test
