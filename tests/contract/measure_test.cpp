// `poreclog-solve measure` and `describe --regime` as scripts see them: keys, types,
// magnitudes in SI, exit codes, and the two streams.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/constants.h"
#include "program.h"

namespace colloid {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kThroat = PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json";
const std::string kCoarse = " --cells-per-colloid 3";

// Reference scene.
constexpr double kCollector = 96.6e-6;
constexpr double kHeight = 144.9e-6;
constexpr double kRadius = 6.65e-6;
constexpr double kSpeed = 0.5e-3;
constexpr double kViscosity = 1e-3;

/// One JSON value on standard output, nothing on standard error, exit code 0.
json answer(const std::string& arguments) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << arguments << '\n' << outcome.err;
  EXPECT_EQ(outcome.err, "") << arguments;
  const json document = json::parse(outcome.out, nullptr, false);
  EXPECT_TRUE(document.is_object()) << arguments << '\n' << outcome.out.substr(0, 300);
  EXPECT_EQ(document.value("schema_version", 0), 1);
  return document;
}

void expect_refused(const std::string& arguments, const std::string& message) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments << '\n' << outcome.err;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

/// The throat with some of its keys replaced, by JSON pointer; null removes.
std::string throat_with(const json& changes, const std::string& name) {
  json scene = json::parse(content(kThroat));
  for (const auto& [pointer, value] : changes.items()) {
    scene[json::json_pointer(pointer)] = value;
  }
  for (const char* key : {"drive", "colloids"}) {
    if (scene[key].is_null()) {
      scene.erase(key);
    }
  }
  return write_temporary(name, scene.dump(1));
}

std::string deposit(const std::string& name, const std::string& rows) {
  return write_temporary(name, "x_m,y_m,z_m,diameter_m\n" + rows);
}

/// The whole cross-section closed by one sphere that covers the collectors' contacts.
std::string plug() {
  return deposit("plug.csv", "48.3e-6,48.3e-6,48.3e-6,100e-6\n");
}

const json kUnderPressure = {{"/drive", {{"pressure_drop", "1 Pa"}}}};

enum class Kind { number, integer, boolean, text, vector, triple_of_integers };

struct Entry {
  const char* pointer;
  Kind kind;
};

bool is_vector(const json& value) {
  return value.is_array() && value.size() == 3 && value[0].is_number() &&
         value[1].is_number() && value[2].is_number();
}

bool is_kind(const json& value, Kind kind) {
  switch (kind) {
    case Kind::number:
      return value.is_number();
    case Kind::integer:
      return value.is_number_integer();
    case Kind::boolean:
      return value.is_boolean();
    case Kind::text:
      return value.is_string() && !value.get<std::string>().empty();
    case Kind::vector:
      return is_vector(value);
    case Kind::triple_of_integers:
      return is_vector(value) && value[0].is_number_integer() &&
             value[1].is_number_integer() && value[2].is_number_integer();
  }
  return false;
}

const std::vector<Entry> kRegime{{"/regime/reynolds_particle", Kind::number},
                                 {"/regime/reynolds_throat", Kind::number},
                                 {"/regime/stokes", Kind::number},
                                 {"/regime/peclet", Kind::number},
                                 {"/regime/gravity_number", Kind::number},
                                 {"/regime/debye_length_m", Kind::number},
                                 {"/regime/capture_gap_m", Kind::number},
                                 {"/regime/energy_barrier_kT", Kind::number},
                                 {"/regime/primary_minimum_kT", Kind::number},
                                 {"/regime/models/brownian", Kind::boolean},
                                 {"/regime/models/gravity", Kind::boolean},
                                 {"/regime/models/inertia", Kind::boolean},
                                 {"/regime/models/lubrication", Kind::boolean},
                                 {"/regime/models/long_range_dlvo", Kind::boolean},
                                 {"/regime/reasons/brownian", Kind::text},
                                 {"/regime/reasons/gravity", Kind::text},
                                 {"/regime/reasons/inertia", Kind::text},
                                 {"/regime/reasons/lubrication", Kind::text},
                                 {"/regime/reasons/long_range_dlvo", Kind::text}};

const std::vector<Entry> kMeasurement{{"/grid/cells", Kind::triple_of_integers},
                                      {"/grid/cell_size_m", Kind::number},
                                      {"/flow/converged", Kind::boolean},
                                      {"/flow/iterations", Kind::integer},
                                      {"/flow/relative_residual", Kind::number},
                                      {"/flow/work_units", Kind::number},
                                      {"/flow/seconds", Kind::number},
                                      {"/flow/pressure_drop_Pa", Kind::number},
                                      {"/flow/flow_rate_m3_s", Kind::number},
                                      {"/flow/superficial_velocity_m_s", Kind::vector},
                                      {"/flow/permeability_m2", Kind::number},
                                      {"/critical_diameter_m", Kind::number}};

void expect_entries(const json& document, const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    const json::json_pointer pointer(entry.pointer);
    ASSERT_TRUE(document.contains(pointer)) << entry.pointer;
    EXPECT_TRUE(is_kind(document[pointer], entry.kind))
        << entry.pointer << ": " << document[pointer];
  }
}

/// Nulls stand for numbers that do not exist; a NaN would end up as one.
std::set<std::string> nulls(const json& document) {
  std::set<std::string> found;
  const json flat = document.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    // flatten() makes empty lists null
    if (document[json::json_pointer(pointer)].is_null()) {
      found.insert(pointer);
    }
  }
  return found;
}

double number(const json& document, const std::string& pointer) {
  return document.at(json::json_pointer(pointer)).get<double>();
}

void expect_relative(const json& document, const std::string& pointer, double expected,
                     double tolerance) {
  EXPECT_NEAR(number(document, pointer), expected, tolerance * std::abs(expected))
      << pointer;
}

TEST(MeasureThroat, GivesEveryKeyOfTheInterface) {
  const json m = answer("measure " + kThroat + kCoarse + " --json");
  expect_entries(m, kMeasurement);
  expect_entries(m, kRegime);
  ASSERT_EQ(m["spheres"].size(), 4U);
  for (const json& sphere : m["spheres"]) {
    EXPECT_TRUE(is_vector(sphere["force_N"])) << sphere;
    EXPECT_TRUE(is_vector(sphere["torque_N_m"])) << sphere;
  }
  EXPECT_EQ(m["bodies"], json::array());
  EXPECT_FALSE(m.contains("profile"));
  // The colloids attract the grains at every gap: no secondary minimum.
  EXPECT_EQ(nulls(m),
            std::set<std::string>({"/regime/pairs/colloid_grain/secondary_minimum_kT"}));
}

// Tolerances: exact relations to rounding, the mean velocity to the solver's residual
// (1e-6).
TEST(MeasureThroat, IsInSiUnits) {
  const json m = answer("measure " + kThroat + kCoarse);
  const double area = kCollector * kCollector;
  EXPECT_EQ(m["grid"]["cells"], json({22, 22, 33}));
  expect_relative(m, "/grid/cell_size_m", kCollector / 22.0, 1e-12);
  EXPECT_EQ(m["flow"]["converged"], true);
  EXPECT_GT(number(m, "/flow/relative_residual"), 0.0);
  EXPECT_LE(number(m, "/flow/relative_residual"), 1e-6);
  EXPECT_GT(number(m, "/flow/work_units"), number(m, "/flow/iterations"));
  expect_relative(m, "/flow/flow_rate_m3_s", kSpeed * area, 1e-9);
  expect_relative(m, "/flow/superficial_velocity_m_s/2", -kSpeed, 1e-5);
  EXPECT_LT(std::abs(number(m, "/flow/superficial_velocity_m_s/0")), 1e-5 * kSpeed);
  const double drop = number(m, "/flow/pressure_drop_Pa");
  expect_relative(m, "/flow/permeability_m2", kSpeed * kViscosity * kHeight / drop, 1e-9);
  // Half of Stokes' drag of a collector, to twenty times it: what a wrong unit cannot
  // meet.
  const double drag = 6.0 * kPi * kViscosity * 0.5 * kCollector * kSpeed;
  for (const json& sphere : m["spheres"]) {
    EXPECT_LT(sphere["force_N"][2].get<double>(), -0.5 * drag);
    EXPECT_GT(sphere["force_N"][2].get<double>(), -20.0 * drag);
  }
  expect_relative(m, "/critical_diameter_m", (std::sqrt(2.0) - 1.0) * kCollector, 1e-8);
}

/// Numbers of physics.md's reference scene, from their formulas.  The throat's open area
/// is sampled to 0.2 %; A a/(6 h^2) is the near-contact form, h/a = 2e-3.
void expect_throat_regime(const json& m) {
  constexpr double thermal = 1.380649e-23 * 298.0;
  expect_relative(m, "/regime/reynolds_particle", 0.00665, 1e-9);
  const double throat_speed = kSpeed / (1.0 - kPi / 4.0);
  const double throat = (std::sqrt(2.0) - 1.0) * kCollector;
  expect_relative(m, "/regime/reynolds_throat",
                  1000.0 * throat_speed * throat / kViscosity, 5e-3);
  expect_relative(m, "/regime/stokes",
                  2.0 * 1050.0 * kRadius * kSpeed / (9.0 * kViscosity), 1e-9);
  expect_relative(m, "/regime/peclet",
                  kSpeed * kRadius * 6.0 * kPi * kViscosity * kRadius / thermal, 1e-6);
  const double settling = 2.0 * 50.0 * 9.81 * kRadius * kRadius / (9.0 * kViscosity);
  expect_relative(m, "/regime/gravity_number", settling / kSpeed, 1e-9);
  const double debye =
      std::sqrt(78.55 * 8.8541878128e-12 * thermal /
                (2.0 * 6.02214076e23 * std::pow(1.602176634e-19, 2) * 300.0));
  expect_relative(m, "/regime/debye_length_m", debye, 1e-4);
  expect_relative(m, "/regime/capture_gap_m",
                  std::sqrt(1e-20 / (36.0 * kPi * kViscosity * kSpeed)), 5e-3);
  EXPECT_EQ(number(m, "/regime/energy_barrier_kT"), 0.0);
  expect_relative(m, "/regime/primary_minimum_kT", -5469.0, 1e-3);
  const json models{{"brownian", false},
                    {"gravity", true},
                    {"inertia", false},
                    {"lubrication", true},
                    {"long_range_dlvo", false}};
  EXPECT_EQ(m["regime"]["models"], models);
}

TEST(MeasureThroat, KnowsTheReferenceRegime) {
  expect_throat_regime(answer("measure " + kThroat + kCoarse));
}

TEST(MeasureThroat, CountsTheDepositAfterTheGrains) {
  const std::string clear = "measure " + kThroat + kCoarse;
  const std::string file = deposit("one.csv", "48.3e-6,48.3e-6,48.3e-6,13.3e-6\n");
  const json before = answer(clear);
  const json after = answer(clear + " --deposit " + file);
  ASSERT_EQ(after["spheres"].size(), 5U);
  const double force = number(after, "/spheres/4/force_N/2");
  EXPECT_LT(force, -6.0 * kPi * kViscosity * kRadius * kSpeed);  // faster than the inlet
  EXPECT_LT(std::abs(number(after, "/spheres/4/force_N/0")), 1e-3 * std::abs(force));
  EXPECT_LT(number(after, "/flow/permeability_m2"),
            0.9 * number(before, "/flow/permeability_m2"));
  // Largest sphere between a ball on the axis and two collectors that touch each other:
  // its centre lies in the throat's plane, on the line from the axis to their contact.
  const double half = 0.5 * kCollector;
  double low = 0.0;
  double high = half;
  for (int n = 0; n < 100; ++n) {
    const double r = 0.5 * (low + high);
    (std::hypot(half, half - (kRadius + r)) > half + r ? low : high) = r;
  }
  expect_relative(after, "/critical_diameter_m", 2.0 * low, 1e-6);
  const std::string header = deposit("none.csv", "");
  EXPECT_EQ(answer(clear + " --deposit " + header)["spheres"].size(), 4U);
}

TEST(MeasureThroat, GivesTheVelocityAlongALine) {
  const json m = answer("measure " + kThroat + kCoarse +
                        " --profile 48.3e-6 48.3e-6 0 48.3e-6 48.3e-6 144.9e-6 7");
  ASSERT_EQ(m["profile"].size(), 7U);
  for (std::size_t n = 0; n < 7; ++n) {
    const json& point = m["profile"][n];
    ASSERT_TRUE(is_vector(point["position_m"]) && is_vector(point["velocity_m_s"]));
    EXPECT_NEAR(point["position_m"][2].get<double>(),
                kHeight * static_cast<double>(n) / 6.0, 1e-12 * kHeight);
    EXPECT_LT(point["velocity_m_s"][2].get<double>(), -0.99 * kSpeed) << n;
  }
  EXPECT_NEAR(number(m, "/profile/6/velocity_m_s/2"), -kSpeed, 1e-9 * kSpeed);  // inlet
  const double throat = -number(m, "/profile/2/velocity_m_s/2");
  EXPECT_GT(throat, kSpeed / (1.0 - kPi / 4.0));  // above the mean there
  EXPECT_LT(throat, 2.5 * kSpeed / (1.0 - kPi / 4.0));
}

// Simple-cubic array, Zick & Homsy (1982): K = 4.292 at the solid fraction 0.125.  26
// cells along the edge are good for 0.5 % (verification/simple_cubic_array).
TEST(MeasureBox, AgreesWithTheSimpleCubicArray) {
  const json m = answer("measure " PORECLOG_SOURCE_DIR
                        "/campaigns/scenes/simple_cubic.scene.json --cells 26 26 26");
  expect_entries(m, kMeasurement);
  EXPECT_EQ(m["grid"]["cells"], json({26, 26, 26}));
  expect_relative(m, "/flow/pressure_drop_Pa", 0.1, 1e-9);
  const double radius = 0.5 * 62.035e-6;
  const double volume = std::pow(100e-6, 3);
  expect_relative(m, "/flow/permeability_m2", volume / (6.0 * kPi * radius * 4.292),
                  5e-3);
  ASSERT_EQ(m["spheres"].size(), 1U);
  expect_relative(m, "/spheres/0/force_N/2", -1000.0 * volume, 1e-5);
  // No colloids: their numbers are null, their keys there.
  std::set<std::string> expected{"/regime/stokes_largest", "/regime/settling_speed_m_s",
                                 "/regime/relaxation_time_s"};
  for (const Entry& entry : kRegime) {
    ASSERT_TRUE(m.contains(json::json_pointer(entry.pointer))) << entry.pointer;
    const std::string pointer = entry.pointer;
    if (pointer.find("reasons") == std::string::npos &&
        pointer != "/regime/reynolds_throat" && pointer != "/regime/models/inertia") {
      expected.insert(pointer);
    }
  }
  EXPECT_EQ(nulls(m), expected);
}

TEST(MeasureBlocked, HasNoFlowUnderPressureAndIsRefusedUnderFlux) {
  const std::string scene = throat_with(kUnderPressure, "pressure.json");
  const json m = answer("measure " + scene + kCoarse + " --deposit " + plug());
  EXPECT_EQ(number(m, "/flow/permeability_m2"), 0.0);
  EXPECT_EQ(number(m, "/flow/flow_rate_m3_s"), 0.0);
  EXPECT_EQ(number(m, "/flow/pressure_drop_Pa"), 1.0);
  EXPECT_EQ(number(m, "/critical_diameter_m"), 0.0);
  // What the grid lets through is the residual: 1e-6 of the open throat's flow at 1 Pa.
  EXPECT_LT(std::abs(number(m, "/flow/superficial_velocity_m_s/2")), 1e-5 * kSpeed);
  EXPECT_EQ(nulls(m).count("/regime/gravity_number"), 1U);
  expect_refused("measure " + kThroat + kCoarse + " --deposit " + plug(),
                 "/drive/inlet_velocity");
}

TEST(MeasureOptions, AreRefusedWithTheOptionsName) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "scene"},
      {kThroat + " --cells-per-colloid 3 --cells 4 4 6", "command line: "},
      {kThroat + " --cells-per-colloid 3 --cells-per-diameter 9", "command line: "},
      {kThroat + " --cells-per-colloid 0", "--cells-per-colloid"},
      {kThroat + " --cells-per-colloid nan", "--cells-per-colloid"},
      {kThroat + " --cells-per-colloid ten", "--cells-per-colloid"},
      {kThroat + " --cells-per-diameter inf", "--cells-per-diameter"},
      {kThroat + " --cells 4 4", "--cells"},
      {kThroat + " --cells 4 4 0", "--cells"},
      {kThroat + " --cells 4 4 -6", "--cells"},
      {kThroat + " --cells 4000 4000 4000", "memory"},
      {kThroat + " --cells-per-colloid 200", "memory"},
      {kThroat + " --profile 0 0 0 1 1", "--profile"},
      {kThroat + kCoarse + " --profile 0 0 0 1e-6 1e-6 1e-6 1", "--profile"},
      {kThroat + kCoarse + " --profile 0 0 0 1e-6 1e-6 1e-6 2.5", "--profile"},
      {kThroat + kCoarse + " --profile 0 0 0 nan 1e-6 1e-6 2", "--profile"},
      {kThroat + kCoarse + " --profile 0 0 0 1 1e-6 1e-6 2", "leaves the box"},
      {kThroat + " --threads 0", "--threads"},
      {kThroat + " --celsius", "--celsius"},
      {PORECLOG_SOURCE_DIR "/campaigns/scenes/square_duct.scene.json" + kCoarse,
       "no colloids"},
      {PORECLOG_SOURCE_DIR
       "/campaigns/scenes/square_duct.scene.json --cells-per-diameter 9",
       "no spheres"},
  };
  for (const auto& [arguments, message] : cases) {
    expect_refused("measure " + arguments, message);
  }
}

TEST(MeasureFiles, AreRefusedByNameAndLine) {
  expect_refused("measure /nowhere/scene.json", "/nowhere/scene.json");
  const std::string scene = "measure " + kThroat + kCoarse + " --deposit ";
  expect_refused(scene + "/nowhere/deposit.csv", "/nowhere/deposit.csv");
  const std::string good = "48.3e-6,48.3e-6,48.3e-6,13.3e-6\n";
  const std::pair<std::string, const char*> cases[] = {
      {good + "48.3e-6,x,48.3e-6,13.3e-6\n", "line 3: y_m"},
      {good + "1,2\n", "line 3: has 2 columns"},
      {"48.3e-6,48.3e-6,48.3e-6,nan\n", "line 2: diameter_m"},
      {"48.3e-6,48.3e-6,48.3e-6,-13.3e-6\n", "line 2: diameter_m"},
      {good + good + "48.3e-6,48.3e-6,900e-6,13.3e-6\n",
       "line 4: the sphere is entirely"},
  };
  for (const auto& [rows, message] : cases) {
    expect_refused(scene + deposit("bad.csv", rows), message);
  }
}

// A force in a closed box: the speed by Stokes' law less what walls at five diameters
// slow down; nothing sideways.
TEST(MeasureScene, MovesBodies) {
  const std::string scene =
      PORECLOG_SOURCE_DIR "/campaigns/scenes/settling_body.scene.json";
  const json m = answer("measure " + scene + " --cells-per-diameter 8");
  const json& body = m.at("bodies").at(0);
  const double stokes = -1e-12 / (6.0 * 3.14159265358979 * 1e-3 * 5e-6);
  EXPECT_GT(body.at("velocity_m_s").at(2).get<double>() / stokes, 0.75);
  EXPECT_LT(body.at("velocity_m_s").at(2).get<double>() / stokes, 0.90);
  EXPECT_NEAR(body.at("velocity_m_s").at(0).get<double>() / stokes, 0.0, 1e-4);
  EXPECT_NEAR(body.at("force_N").at(2).get<double>(), 1e-12, 1e-16);
  EXPECT_NEAR(body.at("torque_N_m").at(1).get<double>() / (1e-12 * 5e-6), 0.0, 1e-4);
  EXPECT_TRUE(m.at("spheres").empty());
}

TEST(MeasureScene, RefusesBodiesThatNothingHolds) {
  std::string text = R"({"geometry": {"box": ["50 um", "50 um", "50 um"],
    "faces": {"x-": "periodic", "x+": "periodic", "y-": "periodic", "y+": "periodic",
              "z-": "periodic", "z+": "periodic"},
    "bodies": [{"center": ["20 um", "20 um", "20 um"], "diameter": "10 um",
                "force": ["0 N", "0 N", "1 pN"]}]},
    "fidelity": {"tier": "quasi_steady"}})";
  expect_refused("measure " + write_temporary("drift.json", text), "/geometry/bodies");
}

// A relative residual of 1e-14 is below what rounding leaves at this grid.
TEST(MeasureScene, ThatDoesNotConvergeExitsWith3) {
  const std::string scene = throat_with(
      {{"/fidelity", {{"cells_per_colloid", 8}, {"tolerance", 1e-14}}}}, "t.json");
  const Outcome outcome = run_program("measure " + scene);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("not converged"));
}

TEST(DescribeRegime, IsTheRegimeThatMeasureGives) {
  const std::string scene = throat_with({{"/fidelity/cells_per_colloid", 3}}, "r.json");
  json d = answer("describe --regime " + scene + " --json");
  expect_entries(d, kRegime);
  expect_throat_regime(d);
  EXPECT_EQ(d.size(), 2U);
  d["regime"].erase("tier");  // questions of a run, which measure does not answer
  d["regime"].erase("cost");
  EXPECT_EQ(d["regime"], answer("measure " + scene)["regime"]);
}

// By which a run chooses its tier; a flow around many touching bodies may not converge.
TEST(DescribeRegime, IsThatOfThePoreWithoutBodies) {
  json changes{{"/fidelity/cells_per_colloid", 3}, {"/fidelity/tier", "quasi_steady"}};
  const auto described = [&] {
    return answer("describe --json --regime " + throat_with(changes, "b.json"));
  };
  const json clean = described();
  changes["/geometry/bodies"] = json::array(
      {{{"center", {"48.3 um", "48.3 um", "48.3 um"}}, {"diameter", "13.3 um"}}});
  EXPECT_EQ(described(), clean);
}

TEST(DescribeRegime, SaysWhichTierRunsWhereAndAtWhatCost) {
  const auto said = [](const json& changes) {
    return answer("describe --json --regime " + throat_with(changes, "t.json"))["regime"];
  };
  const json cheap =
      said({{"/fidelity/cells_per_colloid", 3}, {"/fidelity/tier", "auto"}});
  EXPECT_EQ(cheap["tier"], json({{"name", "one_way"},
                                 {"program", "poreclog-solve"},
                                 {"reason", "the cheapest that is valid"}}));
  EXPECT_TRUE(cheap["cost"].is_null());
  const json fast = said({{"/fidelity/cells_per_colloid", 3},
                          {"/fidelity/tier", "auto"},
                          {"/drive/inlet_velocity", "50 mm/s"}});
  EXPECT_EQ(fast["tier"]["name"], "transient");
  EXPECT_EQ(fast["tier"]["program"], "poreclog-solve-transient");
  EXPECT_THAT(fast["tier"]["reason"].get<std::string>(), HasSubstr("Re_throat = 9."));
  for (const char* key : {"cells", "steps", "seconds"}) {
    EXPECT_GT(fast["cost"][key], 0.0) << key;
  }
}

TEST(DescribeRegime, IsATableForPeople) {
  const std::string scene = throat_with({{"/fidelity/cells_per_colloid", 3}}, "r.json");
  const Outcome outcome = run_program("describe --regime " + scene);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(json::parse(outcome.out, nullptr, false).is_discarded());
  for (const char* line : {"Debye length              5.554", " m\n",
                           "gravity         yes", "inertia         no", "Re_throat = "}) {
    EXPECT_THAT(outcome.out, HasSubstr(line));
  }
}

TEST(DescribeRegime, KnowsScenesWithoutColloidsAndWithoutDrive) {
  const std::string pure =
      throat_with({{"/colloids", nullptr}, {"/fidelity", json::object()}}, "pure.json");
  const json flow = answer("describe --regime " + pure + " --json");
  EXPECT_TRUE(flow["regime"]["peclet"].is_null());
  EXPECT_GT(number(flow, "/regime/reynolds_throat"), 0.05);
  EXPECT_EQ(flow["regime"]["models"]["inertia"], false);

  const std::string still = write_temporary(
      "still.json",
      R"({"geometry": {"box": ["50 um", "50 um", "50 um"]}, "colloids": {"diameter": "10 um"}})");
  const json rest = answer("describe --regime " + still + " --json");
  EXPECT_EQ(number(rest, "/regime/peclet"), 0.0);
  EXPECT_EQ(rest["regime"]["models"]["brownian"], true);
  EXPECT_TRUE(rest["regime"]["gravity_number"].is_null());
  EXPECT_TRUE(
      rest["regime"]["capture_gap_m"].is_null());  // nothing opposes the attraction

  expect_refused("describe --regime " + still + " --scene " + still, "command line: ");
  expect_refused("describe --regime", "--regime");
}

}  // namespace
}  // namespace colloid
