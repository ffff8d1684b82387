#include "scene/read_scene.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/constants.h"
#include "core/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

const std::string kCampaigns = PORECLOG_SOURCE_DIR "/campaigns/";

// The values are those of the table in physics.md, section 1 (Liu, Shikhov & Arns 2024).
TEST(ReadScene, GivesTheReferenceSceneInSi) {
  const Scene scene = read_scene(kCampaigns + "throat.scene.json").scene;
  EXPECT_EQ(scene.geometry.box.size, (Vec3{96.6e-6, 96.6e-6, 144.9e-6}));
  EXPECT_EQ(scene.geometry.spheres.size(), 4U);
  EXPECT_EQ(scene.fluid.viscosity, 1e-3);
  EXPECT_EQ(scene.drive.inlet_velocity, 0.5e-3);
  ASSERT_TRUE(scene.colloids);
  EXPECT_EQ(scene.colloids->diameter, 13.3e-6);
  EXPECT_EQ(scene.colloids->young_modulus, 70e6);
  EXPECT_EQ(scene.grains.young_modulus, 20e9);
  EXPECT_EQ(scene.surface.ionic_strength, 300.0);
  EXPECT_EQ(scene.surface.zeta_wall, -15.7e-3) << "one zeta_grain holds for walls too";
  EXPECT_EQ(scene.surface.hamaker_colloid_colloid, 1e-20);
  EXPECT_FALSE(scene.surface.primary_minimum) << "computed";
  EXPECT_EQ(scene.duration, 5.0);
  EXPECT_EQ(scene.fidelity.tier, TierChoice::one_way);
}

TEST(ReadScene, FillsEveryKindOfKey) {
  const Scene scene = read_scene(kCampaigns + "scenes/random_pack.scene.json").scene;
  EXPECT_EQ(scene.geometry.spheres.size(), 90U);
  EXPECT_EQ(scene.geometry.spheres[0].center.x, 2.359248e-04);
  EXPECT_EQ(scene.surface.zeta_grain, -20e-3);
  EXPECT_EQ(scene.surface.zeta_wall, -35e-3);
  EXPECT_EQ(scene.surface.hamaker_colloid_wall, 8e-21);
  EXPECT_DOUBLE_EQ(scene.surface.primary_minimum.value(), -3042.0 * kBoltzmann * 298.0);
  EXPECT_EQ(scene.walls, Walls::adhesive);
  EXPECT_EQ(scene.stop_when, StopWhen::clogged);
  EXPECT_EQ(scene.fidelity.capture_gap, 10e-9);
  EXPECT_EQ(scene.fidelity.tier, TierChoice::automatic);
}

TEST(ReadScene, ReadsBodiesForTheTiersThatMoveThem) {
  const SceneFile file = read_scene(kCampaigns + "scenes/settling_body.scene.json");
  ASSERT_EQ(file.scene.geometry.bodies.size(), 1U);
  const Body& body = file.scene.geometry.bodies[0];
  EXPECT_EQ(body.sphere.radius, 5e-6);
  EXPECT_EQ(body.force.z, -1e-12);
  EXPECT_FALSE(body.velocity);
  EXPECT_FALSE(file.scene.colloids);
  EXPECT_FALSE(file.scene.drive.given());
  EXPECT_NO_THROW(check_starting_colloids(file));
}

TEST(ReadScene, StartsNoRunWithAPrescribedVelocity) {
  const SceneFile file = parse_scene(R"({"geometry": {"preset": "throat", "bodies": [
        {"center": ["48 um", "48 um", "130 um"], "diameter": "13.3 um",
         "velocity": ["0 m/s", "0 m/s", "1 um/s"]}]},
        "colloids": {"diameter": "13.3 um"}, "drive": {"inlet_velocity": "0.5 mm/s"}})",
                                     "s.json");
  try {
    check_starting_colloids(file);
    FAIL() << "a body that is moved was not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/geometry/bodies/0/velocity: is prescribed"));
  }
}

TEST(ReadScene, StartsARunWithColloidsOfOneSize) {
  const auto start = [](const std::string& diameter) {
    check_starting_colloids(parse_scene(R"({"geometry": {"preset": "throat", "bodies": [
        {"center": ["48 um", "48 um", "130 um"], "diameter": ")" +
                                            diameter + R"("}]},
        "colloids": {"diameter": "13.3 um"}, "drive": {"inlet_velocity": "0.5 mm/s"}})",
                                        "s.json"));
  };
  EXPECT_NO_THROW(start("13.3 um"));
  try {
    start("13 um");
    FAIL() << "a colloid of another size was not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/geometry/bodies/0/diameter"));
    EXPECT_THAT(error.what(), HasSubstr("1.33e-05"));
  }
}

TEST(ReadScene, TakesTheTemperatureOfTheSceneForKT) {
  const auto minimum = [](const std::string& fluid) {
    return *parse_scene(R"({"surface": {"primary_minimum": "-10 kT"},
        "geometry": {"box": ["1 um", "1 um", "1 um"]})" +
                            fluid + "}",
                        "s.json")
                .scene.surface.primary_minimum;
  };
  EXPECT_DOUBLE_EQ(minimum(""), -10.0 * kBoltzmann * 298.0) << "the default temperature";
  EXPECT_DOUBLE_EQ(minimum(R"(, "fluid": {"temperature": "350 K"})"),
                   -10.0 * kBoltzmann * 350.0);
}

TEST(ReadScene, ReadsEveryTierWhetherItExistsOrNot) {
  for (const char* tier : {"auto", "one_way", "quasi_steady", "transient"}) {
    const std::string text = R"({"geometry": {"box": ["1 um", "1 um", "1 um"]},
                                 "fidelity": {"tier": ")" +
                             std::string(tier) + "\"}}";
    EXPECT_NO_THROW(parse_scene(text, "s.json")) << tier;
  }
}

}  // namespace
}  // namespace colloid
