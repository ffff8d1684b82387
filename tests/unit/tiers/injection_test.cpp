#include "tiers/injection.h"

#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/constants.h"
#include "core/error.h"
#include "scene/read_scene.h"

namespace colloid {
namespace {

using testing::HasSubstr;

constexpr double kWidth = 96.6e-6;
constexpr double kRadius = 6.65e-6;
constexpr double kSpeed = 0.5e-3;

Scene reference_scene() {
  return read_scene(PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json").scene;
}

/// 60 x 48 x 90 um, faces x- to z+ of the words of a scene; colloids of 12 um.
Scene box_scene(const std::array<const char*, 6>& faces, const std::string& drive,
                const std::string& spheres = "") {
  const std::string text = fmt::format(
      R"({{"geometry": {{"box": ["60 um", "48 um", "90 um"], "faces": {{
           "x-": "{}", "x+": "{}", "y-": "{}", "y+": "{}", "z-": "{}", "z+": "{}"}},
           "spheres": [{}]}},
           "drive": {{{}}}, "colloids": {{"diameter": "12 um"}}}})",
      faces[0], faces[1], faces[2], faces[3], faces[4], faces[5], spheres, drive);
  return parse_scene(text, "box.json").scene;
}

constexpr std::array<const char*, 6> kDuct{"wall", "wall",   "wall",
                                           "wall", "outlet", "inlet"};
const std::string kInletVelocity = R"("inlet_velocity": "0.5 mm/s")";

InjectionSequence sequence_of(const Scene& scene, std::uint64_t seed = 42) {
  return {make_injection_plan(scene, clean_inlet(scene).capture_gap), seed};
}

constexpr int kCount = 200;

void expect_same(const Scene& a, const Scene& b) {
  InjectionSequence one = sequence_of(a);
  InjectionSequence other = sequence_of(b);
  for (int i = 0; i < kCount; ++i) {
    EXPECT_EQ(one.at(i).volume, other.at(i).volume);
    EXPECT_EQ(one.at(i).position, other.at(i).position);
    EXPECT_EQ(one.at(i).redraws, other.at(i).redraws);
  }
}

// Hamaker's attraction of sphere and plate, A a/(6 h^2) (1 - h/a + O(h/a)^2), equals
// Stokes' drag 6 pi mu a U at h = h0 (1 - h0/(2 a)), h0 = sqrt(A/(36 pi mu U)).
// Tolerance: (h0/a)^2 = 4e-6.
TEST(CleanInlet, OfTheReferenceSceneIsItsInletVelocity) {
  const CleanInlet inlet = clean_inlet(reference_scene());
  EXPECT_NEAR(inlet.flow_rate / (kSpeed * kWidth * kWidth), 1.0, 1e-15);
  EXPECT_NEAR(inlet.mean_speed / kSpeed, 1.0, 1e-15);
  const double h0 = std::sqrt(1e-20 / (36.0 * kPi * 1e-3 * kSpeed));
  EXPECT_NEAR(inlet.capture_gap / (h0 * (1.0 - h0 / (2.0 * kRadius))), 1.0, 4e-6);
}

// Reference: a duct of 48 x 60 um under 1 Pa over 90 um, by the series of Boussinesq:
// k = b^2/12 [1 - (192 b/(pi^5 a)) sum over odd n of tanh(n pi a/(2 b))/n^5], b < a.
// Tolerance: 22 and 28 cells across; verification/duct measured +9.3e-4 at 24 cells
// across a square, falling with the square of the cell: 1.1e-3 at 22; with half as much
// again, 1.7e-3.
TEST(CleanInlet, SolvesTheFlowUnderAPressureDrop) {
  const double a = 60e-6;
  const double b = 48e-6;
  double sum = 0.0;
  for (int n = 1; n < 200; n += 2) {
    sum += std::tanh(n * kPi * a / (2.0 * b)) / std::pow(n, 5);
  }
  const double k = b * b / 12.0 * (1.0 - 192.0 * b / (std::pow(kPi, 5) * a) * sum);
  const double speed = k * 1.0 / (1e-3 * 90e-6);
  const CleanInlet inlet = clean_inlet(box_scene(kDuct, R"("pressure_drop": "1 Pa")"));
  EXPECT_NEAR(inlet.mean_speed / speed, 1.0, 1.7e-3);
  EXPECT_NEAR(inlet.flow_rate / (speed * a * b), 1.0, 1.7e-3);
}

// A grain that reaches through the inlet closes a disc of it.  Tolerance: the disc is 7 %
// of the face, its area on the grid of 22 x 28 cells is right within a cell's width of
// its rim for each cell on it, at random: below 1 % of the face.
TEST(CleanInlet, LeavesOutTheGrainsInTheInletPlane) {
  const Scene scene =
      box_scene(kDuct, kInletVelocity,
                R"({"center": ["30 um", "24 um", "86 um"], "diameter": "18 um"})");
  const double open = 1.0 - kPi * (81.0 - 16.0) / (60.0 * 48.0);
  EXPECT_NEAR(clean_inlet(scene).mean_speed / kSpeed, open, 0.01);
}

TEST(CleanInlet, RefusesWhatCarriesNothingIn) {
  const auto refusal = [](const Scene& scene) -> std::string {
    try {
      clean_inlet(scene);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  Scene scene = reference_scene();
  scene.colloids.reset();
  EXPECT_THAT(refusal(scene), HasSubstr("/colloids: is missing"));
  scene = box_scene({"wall", "wall", "wall", "wall", "periodic", "periodic"},
                    R"("body_force": ["0 N/m^3", "0 N/m^3", "-1 N/m^3"])");
  EXPECT_THAT(refusal(scene), HasSubstr("/geometry/faces: has no inlet"));
  // Closed by a sphere wider than the duct.
  const std::string plug =
      R"({"center": ["30 um", "24 um", "40 um"], "diameter": "80 um"})";
  EXPECT_THAT(refusal(box_scene(kDuct, R"("pressure_drop": "1 Pa")", plug)),
              HasSubstr("/drive: moves no liquid through the inlet"));
}

TEST(InjectionPlan, OfTheReferenceScene) {
  const InjectionPlan plan = make_injection_plan(reference_scene(), 13e-9);
  EXPECT_EQ(plan.inlet_face, z_plus);
  EXPECT_DOUBLE_EQ(plan.low.x, kRadius + 13e-9);
  EXPECT_DOUBLE_EQ(plan.low.y, kRadius + 13e-9);
  EXPECT_DOUBLE_EQ(plan.high.x, kWidth - kRadius - 13e-9);
  EXPECT_DOUBLE_EQ(plan.high.y, kWidth - kRadius - 13e-9);
  EXPECT_DOUBLE_EQ(plan.low.z, 144.9e-6 - kRadius);
  EXPECT_EQ(plan.high.z, plan.low.z);
  EXPECT_DOUBLE_EQ(plan.inlet_area, kWidth * kWidth);
  EXPECT_DOUBLE_EQ(plan.colloid_radius, kRadius);
  EXPECT_EQ(plan.volume_fraction, 0.005);
  EXPECT_EQ(plan.capture_gap, 13e-9);
  EXPECT_EQ(plan.periodic, (std::array<bool, 3>{false, false, false}));
  EXPECT_TRUE(plan.grains.empty());  // their tops are half a collector below
}

TEST(InjectionPlan, TakesAxisSideAndPeriodsFromTheFaces) {
  const std::string far =
      R"({"center": ["60 um", "20 um", "50 um"], "diameter": "20 um"})";
  const std::string near =
      R"({"center": ["15 um", "20 um", "50 um"], "diameter": "10 um"})";
  const Scene scene =
      box_scene({"inlet", "outlet", "periodic", "periodic", "symmetry", "wall"},
                kInletVelocity, far + ", " + near);
  const InjectionPlan plan = make_injection_plan(scene, 1e-6);
  EXPECT_EQ(plan.inlet_face, x_minus);
  EXPECT_EQ(plan.periodic, (std::array<bool, 3>{false, true, false}));
  EXPECT_DOUBLE_EQ(plan.low.x, 6e-6);
  EXPECT_DOUBLE_EQ(plan.high.x, 6e-6);
  EXPECT_EQ(plan.low.y, 0.0);
  EXPECT_DOUBLE_EQ(plan.high.y, 48e-6);
  EXPECT_DOUBLE_EQ(plan.low.z, 7e-6);
  EXPECT_DOUBLE_EQ(plan.high.z, 83e-6);
  EXPECT_DOUBLE_EQ(plan.inlet_area, 48e-6 * 90e-6);
  ASSERT_EQ(plan.grains.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.grains[0].center.x, 15e-6);
}

TEST(InjectionPlan, RefusesWhatCannotBeInjected) {
  const auto refusal = [](const Scene& scene, double capture_gap) -> std::string {
    try {
      make_injection_plan(scene, capture_gap);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  Scene scene = reference_scene();
  scene.colloids->diameter = 96.5e-6;
  EXPECT_EQ(refusal(scene, 0.04e-6), "accepted");
  EXPECT_THAT(refusal(scene, 0.06e-6), HasSubstr("/colloids/diameter: is 9.65e-05 m"));
  scene.geometry.box.faces = {FaceCondition::periodic, FaceCondition::periodic,
                              FaceCondition::periodic, FaceCondition::periodic,
                              FaceCondition::outlet,   FaceCondition::inlet};
  EXPECT_THAT(refusal(scene, 0.06e-6), HasSubstr("/colloids/diameter"));
  scene.colloids.reset();
  EXPECT_THAT(refusal(scene, 1e-9), HasSubstr("/colloids: is missing"));
  scene = reference_scene();
  scene.geometry.box.faces[x_plus] = FaceCondition::inlet;
  EXPECT_THAT(refusal(scene, 1e-9), HasSubstr("/geometry/faces/z+: is a second inlet"));
  scene.geometry.box.faces[x_plus] = FaceCondition::wall;
  scene.geometry.box.faces[z_plus] = FaceCondition::wall;
  EXPECT_THAT(refusal(scene, 1e-9), HasSubstr("has no inlet"));
}

// What says how accurately a scene is computed must not touch what is computed.
TEST(Injections, AreTheSameForEveryFidelity) {
  Scene flux = reference_scene();
  Scene pressure = flux;
  pressure.drive = Drive{};
  pressure.drive.pressure_drop = 2.0;
  const std::vector<std::function<void(Scene&)>> options{
      [](Scene& s) { s.fidelity.cells_per_colloid = 3.0; },
      [](Scene& s) { s.fidelity.tier = TierChoice::quasi_steady; },
      [](Scene& s) { s.fidelity.tier = TierChoice::transient; },
      [](Scene& s) { s.fidelity.capture_gap = 1e-6; },
      [](Scene& s) { s.fidelity.tolerance = 1e-3; },
      [](Scene& s) { s.fidelity.hindrance = Hindrance::none; },
      [](Scene& s) { s.duration = 1.0; },
      [](Scene& s) { s.bonds = Bonds::breakable; }};
  for (const Scene& scene : {flux, pressure}) {
    for (const auto& change : options) {
      Scene changed = scene;
      change(changed);
      expect_same(scene, changed);
    }
  }
}

// The drive sets the inlet's speed and with it the capture gap, nothing else: volumes are
// the same, positions move by no more than the gaps differ.
TEST(Injections, AreTheSameForEveryDriveButForTheCaptureGap) {
  Scene flux = reference_scene();
  flux.colloids->volume_fraction = 0.05;  // so that some are redrawn
  Scene pressure = flux;
  pressure.drive = Drive{};
  pressure.drive.pressure_drop = 4.0;
  InjectionSequence one = sequence_of(flux);
  InjectionSequence other = sequence_of(pressure);
  const double gaps = one.plan().capture_gap - other.plan().capture_gap;
  EXPECT_GT(gaps, 1e-9);  // the flow is about twice as fast
  int redraws = 0;
  for (int i = 0; i < kCount; ++i) {
    const InjectedColloid& a = one.at(i);
    const InjectedColloid& b = other.at(i);
    EXPECT_EQ(a.volume, b.volume);
    EXPECT_EQ(a.redraws, b.redraws);
    EXPECT_NEAR(a.position.x, b.position.x, gaps);
    EXPECT_NEAR(a.position.y, b.position.y, gaps);
    EXPECT_EQ(a.position.z, b.position.z);
    redraws += a.redraws;
  }
  EXPECT_GT(redraws, 20);
}

}  // namespace
}  // namespace colloid
