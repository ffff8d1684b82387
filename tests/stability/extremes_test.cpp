// Extreme values of flow, geometry and surface forces: a fast part of
// scripts/extremes.py, with what physics says about each.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.h"

namespace colloid {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr int kSeconds = 20;  // far above what any of these needs
constexpr double kCollector = 96.6e-6;
constexpr double kRadius = 6.65e-6;
const double kThroat = (std::sqrt(2.0) - 1.0) * kCollector;

json throat(const json& changes) {
  json scene = json::parse(content(PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json"));
  for (const auto& [pointer, value] : changes.items()) {
    scene[json::json_pointer(pointer)] = value;
  }
  return scene;
}

const json kUnderPressure{{"/drive", {{"pressure_drop", "1 Pa"}}}};

using Rows = std::vector<std::array<double, 4>>;  // x, y, z, diameter [m]

Outcome measure(const json& scene, const Rows& deposit = {},
                const std::string& grid = "--cells-per-colloid 3") {
  std::string table = "x_m,y_m,z_m,diameter_m\n";
  for (const auto& row : deposit) {
    table += json(row).dump().substr(1);
    table.back() = '\n';
  }
  return run_program("measure " + write_temporary("scene.json", scene.dump()) +
                         " --deposit " + write_temporary("deposit.csv", table) + " " +
                         grid,
                     kSeconds);
}

json survived(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json document = json::parse(outcome.out, nullptr, false);
  EXPECT_TRUE(document.is_object()) << outcome.out.substr(0, 300);
  return document;
}

void expect_refused(const Outcome& outcome, const char* message) {
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(message));
}

double number(const json& document, const char* pointer) {
  const json& value = document.at(json::json_pointer(pointer));
  EXPECT_TRUE(value.is_number()) << pointer << ": " << value;
  return value.is_number() ? value.get<double>() : NAN;
}

// The Debye length is that of 1:1 electrolytes, ~ I^-1/2 exactly.
TEST(Extremes, OfIonicStrengthScaleTheDebyeLength) {
  const double at_300_mM = 5.5544e-10;  // physics.md, section 2
  for (const double molar : {1e-4, 1e-2, 5.0}) {
    const json m = survived(
        measure(throat({{"/surface/ionic_strength", json(molar).dump() + " M"}})));
    EXPECT_NEAR(number(m, "/regime/debye_length_m") / at_300_mM, std::sqrt(0.3 / molar),
                2e-4 * std::sqrt(0.3 / molar));
    EXPECT_EQ(number(m, "/regime/energy_barrier_kT") > 0.0, molar < 0.1) << molar;
  }
}

TEST(Extremes, OfChargeAndHamakerDecideTheBarrier) {
  struct Chemistry {
    const char* hamaker;
    const char* colloid;
    const char* grain;
    bool barrier;
  };
  // Opposite signs attract; equal ones repel, and without attraction all the way in.
  for (const Chemistry& c :
       {Chemistry{"1e-20 J", "-200 mV", "200 mV", false},
        Chemistry{"1e-20 J", "0 mV", "0 mV", false},
        Chemistry{"1e-20 J", "-100 mV", "-100 mV", true},
        Chemistry{"0 J", "-1 V", "-1 V", true}, Chemistry{"0 J", "0 mV", "0 mV", false},
        Chemistry{"1e-17 J", "-27.9 mV", "-15.7 mV", false}}) {
    const json m = survived(measure(throat({{"/surface/hamaker", c.hamaker},
                                            {"/surface/zeta_colloid", c.colloid},
                                            {"/surface/zeta_grain", c.grain}})));
    EXPECT_EQ(number(m, "/regime/energy_barrier_kT") > 0.0, c.barrier)
        << c.hamaker << ", " << c.colloid << ", " << c.grain;
  }
}

// Stokes flow is linear: k does not see the speed, the viscosity or the pressure.
TEST(Extremes, OfSpeedAndViscosityLeaveThePermeability) {
  const double usual =
      number(survived(measure(throat(json::object()))), "/flow/permeability_m2");
  for (const json& change : {json{{"/drive/inlet_velocity", "1e-6 m/s"}},
                             json{{"/drive/inlet_velocity", "0.1 m/s"}},
                             json{{"/fluid/viscosity", "1e-9 Pa s"}},
                             json{{"/fluid/viscosity", "1e6 Pa s"}}}) {
    const json m = survived(measure(throat(change)));
    EXPECT_NEAR(number(m, "/flow/permeability_m2") / usual, 1.0, 1e-5) << change;
  }
  const json fast = survived(measure(throat({{"/drive/inlet_velocity", "0.1 m/s"}})));
  EXPECT_EQ(fast["regime"]["models"]["inertia"], true);
  const json slow = survived(measure(throat({{"/drive/inlet_velocity", "1e-7 m/s"}})));
  EXPECT_EQ(slow["regime"]["models"]["brownian"], true);
}

// Between a colloid on a collector and the collector opposite: the gap to the grain it
// sits on, 1e-1 to 1e-4 a and closed, is never the widest way, so l_c goes to that of
// contact, and the force on it stays finite.
TEST(Extremes, OfGapsChangeTheFlowNoMoreThanTheGeometry) {
  const auto at_gap = [](double gap) {
    const double r = (0.5 * kCollector + (1.0 + gap) * kRadius) / std::sqrt(2.0);
    return survived(
        measure(throat(json::object()), {{r, r, 0.5 * kCollector, 2.0 * kRadius}}));
  };
  const json touching = at_gap(0.0);
  for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4}) {
    const json m = at_gap(gap);
    for (const char* pointer :
         {"/critical_diameter_m", "/flow/permeability_m2", "/spheres/4/force_N/2"}) {
      const double ratio = number(m, pointer) / number(touching, pointer);
      EXPECT_NEAR(ratio, 1.0, gap) << pointer << " at " << gap << " a";
    }
  }
}

TEST(Extremes, OfResolutionConverge) {
  const json scene = throat(json::object());
  const double fine = number(survived(measure(scene, {}, "--cells-per-colloid 6")),
                             "/flow/permeability_m2");
  for (const auto& [cells, error] : {std::pair{"2", 0.08}, std::pair{"4", 0.02}}) {
    const json m =
        survived(measure(scene, {}, std::string("--cells-per-colloid ") + cells));
    EXPECT_NEAR(number(m, "/flow/permeability_m2") / fine, 1.0, error) << cells;
  }
  for (const char* grid : {"--cells 1 1 1", "--cells 1 1 60", "--cells 64 1 64",
                           "--cells 500 2 2", "--cells 2 3 5"}) {
    const json m = survived(measure(scene, {}, grid));
    EXPECT_GT(number(m, "/flow/permeability_m2"), 0.0) << grid;
    EXPECT_NEAR(number(m, "/critical_diameter_m"), kThroat, 1e-8 * kThroat) << grid;
  }
  expect_refused(measure(scene, {}, "--cells-per-colloid 200"), "memory");
}

TEST(Extremes, OfDepositedSizeNarrowTheThroatContinuously) {
  for (const json& drive : {json::object(), kUnderPressure}) {
    const auto with = [&](double ratio) {
      const double c = 0.5 * kCollector;
      return survived(measure(throat(drive), {{c, c, c, ratio * kThroat}}));
    };
    const double exact = number(with(1.0), "/flow/permeability_m2");
    EXPECT_GT(exact, 0.0);
    const double below = number(with(0.99), "/flow/permeability_m2") / exact;
    const double above = number(with(1.01), "/flow/permeability_m2") / exact;
    EXPECT_GT(below, 1.0);
    EXPECT_LT(below, 1.15);
    EXPECT_LT(above, 1.0);
    EXPECT_GT(above, 0.85);
  }
}

TEST(Extremes, OfClusterAndPlug) {
  // Four touching spheres from collector to collector leave two ways past them.
  Rows chain;
  const double d = kThroat / 4.0;
  for (int n = 0; n < 4; ++n) {
    const double r = (0.5 * kCollector + (n + 0.5) * d) / std::sqrt(2.0);
    chain.push_back({r, r, 0.5 * kCollector, d});
  }
  const json crossed = survived(measure(throat(json::object()), chain));
  EXPECT_GT(number(crossed, "/critical_diameter_m"), 0.0);
  EXPECT_LT(number(crossed, "/critical_diameter_m"), 0.5 * kThroat);
  EXPECT_GT(number(crossed, "/flow/pressure_drop_Pa"), 0.0);

  const double c = 0.5 * kCollector;
  const Rows plug{{c, c, c, 1.04 * kCollector}};
  expect_refused(measure(throat(json::object()), plug), "/drive/inlet_velocity");
  const json blocked = survived(measure(throat(kUnderPressure), plug));
  EXPECT_EQ(number(blocked, "/flow/permeability_m2"), 0.0);
  EXPECT_EQ(number(blocked, "/critical_diameter_m"), 0.0);
}

// 7 x 7 touching spheres on one cell each: the grid has no way left, the pore has.
TEST(Extremes, OfTouchingLayersDoNotBlockTheGrid) {
  Rows layer;
  const double d = kCollector / 7.0;
  for (int n = 0; n < 49; ++n) {
    layer.push_back({(n % 7 + 0.5) * d, (n / 7 + 0.5) * d, 120e-6, d});
  }
  for (const char* grid : {"--cells-per-colloid 1", "--cells-per-colloid 2"}) {
    const json m = survived(measure(throat(json::object()), layer, grid));
    EXPECT_NEAR(number(m, "/critical_diameter_m"), (std::sqrt(2.0) - 1.0) * d, 1e-8 * d);
    EXPECT_GT(number(m, "/flow/permeability_m2"), 0.0);
  }
}

TEST(Extremes, OfBoxesWithoutResistanceAreRefused) {
  json scene = json::parse(R"({"geometry": {"box": ["50 um", "50 um", "50 um"], "faces": {
      "x-": "periodic", "x+": "periodic", "y-": "symmetry", "y+": "symmetry",
      "z-": "outlet", "z+": "inlet"}}, "drive": {"pressure_drop": "1 Pa"}})");
  const std::string grid = "--cells 10 10 10";
  expect_refused(measure(scene, {}, grid), "/drive/pressure_drop: meets no resistance");
  scene["drive"] = {{"inlet_velocity", "1 mm/s"}};
  const json plug_flow = survived(measure(scene, {}, grid));
  EXPECT_NEAR(number(plug_flow, "/regime/largest_speed_m_s"), 1e-3, 1e-8);
  EXPECT_TRUE(plug_flow["flow"]["permeability_m2"].is_null());
  EXPECT_EQ(number(plug_flow, "/flow/pressure_drop_Pa"), 0.0);
  scene["drive"] = {{"pressure_drop", "1 Pa"}};
  EXPECT_GT(number(survived(measure(scene, {{25e-6, 25e-6, 25e-6, 10e-6}}, grid)),
                   "/flow/permeability_m2"),
            0.0);
}

}  // namespace
}  // namespace colloid
