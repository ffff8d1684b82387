// A scene with every default spelled out must be the same scene, bit for bit: the
// orchestrator hashes and stores it, and a result must be reproducible from it.
#include <cstring>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/field_lister.h"
#include "scene/read_scene.h"

namespace colloid {
namespace {

const std::string kScenes = PORECLOG_SOURCE_DIR "/campaigns/scenes/";

const char* const kAllBranches[] = {
    PORECLOG_SOURCE_DIR "/campaigns/throat.scene.json",
    PORECLOG_SOURCE_DIR "/campaigns/scenes/random_pack.scene.json",
    PORECLOG_SOURCE_DIR "/campaigns/scenes/settling_body.scene.json",
    PORECLOG_SOURCE_DIR "/campaigns/scenes/shear.scene.json",
    PORECLOG_SOURCE_DIR "/campaigns/scenes/simple_cubic.scene.json",
    PORECLOG_SOURCE_DIR "/campaigns/scenes/square_duct.scene.json",
};

TEST(WriteScene, RoundTripsEveryExample) {
  for (const char* path : kAllBranches) {
    const Scene scene = read_scene(path).scene;
    const std::string once = to_json(scene).dump();
    const Scene back = parse_scene(once, "elsewhere/s.json").scene;
    EXPECT_EQ(to_json(back).dump(), once) << path;
    ASSERT_EQ(back.geometry.spheres.size(), scene.geometry.spheres.size());
    for (std::size_t i = 0; i < back.geometry.spheres.size(); ++i) {
      EXPECT_EQ(std::memcmp(&back.geometry.spheres[i], &scene.geometry.spheres[i],
                            sizeof(Sphere)),
                0)
          << path << ", sphere " << i;
    }
    EXPECT_EQ(back.geometry.box.size, scene.geometry.box.size);
    EXPECT_EQ(back.geometry.box.faces, scene.geometry.box.faces);
    EXPECT_EQ(back.surface.primary_minimum, scene.surface.primary_minimum);
    EXPECT_EQ(back.drive.inlet_velocity, scene.drive.inlet_velocity);
    EXPECT_EQ(back.drive.pressure_drop, scene.drive.pressure_drop);
    EXPECT_EQ(back.drive.shear_rate, scene.drive.shear_rate);
    EXPECT_EQ(back.colloids.has_value(), scene.colloids.has_value());
  }
}

/// Whether `pointer` with "*" for any index leads to a value.
bool contains(const nlohmann::ordered_json& json, std::string pointer) {
  for (std::size_t star = pointer.find('*'); star != std::string::npos;
       star = pointer.find('*')) {
    pointer[star] = '0';
  }
  return json.contains(nlohmann::ordered_json::json_pointer(pointer));
}

// Over all examples together every key appears, so none is read but not written.  In each
// example every key with a default appears whose section is there.
TEST(WriteScene, SpellsOutEveryKey) {
  for (const FieldRow& row : list_fields()) {
    bool written = row.pointer == "/geometry/spheres_file";  // its spheres are listed
    for (const char* path : kAllBranches) {
      written = written || contains(to_json(read_scene(path).scene), row.pointer);
    }
    EXPECT_TRUE(written) << row.pointer;
  }
  const auto throat = to_json(parse_scene(R"({"geometry": {"preset": "throat"},
      "drive": {"pressure_drop": "1 Pa"}, "colloids": {"diameter": "1 um"}})",
                                          "s.json")
                                  .scene);
  for (const char* pointer :
       {"/geometry/height", "/fluid/viscosity", "/colloids/injection/sequence",
        "/surface/hamaker/colloid_wall", "/gravity/2", "/fidelity/capture_gap"}) {
    EXPECT_TRUE(contains(throat, pointer)) << pointer;
  }
}

}  // namespace
}  // namespace colloid
