#include "scene/read_scene.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "core/text_file.h"
#include "scene/check.h"
#include "scene/field_reader.h"
#include "scene/field_writer.h"
#include "scene/json_text.h"
#include "scene/sphere_table.h"
#include "scene/throat.h"

namespace colloid {

namespace {

InputError located(const SceneFile& file, const std::string& pointer,
                   const std::string& why) {
  const TextPosition position = locate(file.text, pointer);
  return {fmt::format("{} {}: {}", file.path, to_string(position), printable(pointer)),
          why};
}

/// Adds file and line to the refusals of `step`, which know only the JSON pointer.
template <class Step>
void with_location(const SceneFile& file, Step step) {
  try {
    step();
  } catch (const InputError& error) {
    throw located(file, error.where(), error.why());
  }
}

/// The path of spheres_file, seen from the scene's folder.
std::string resolved(const SceneFile& file) {
  const std::string& given = file.scene.geometry.spheres_file;
  const std::filesystem::path path =
      std::filesystem::path(file.path).parent_path() / given;
  with_location(file, [&] {
    require(
        std::filesystem::exists(path), "/geometry/spheres_file",
        fmt::format("is {}, but there is no file {}", in_quotes(given), path.string()));
  });
  return path.string();
}

void append_sphere_table(SceneFile& file) {
  const std::string path = resolved(file);
  const std::vector<Sphere> table = read_sphere_table(path, file.scene.geometry.box);
  require(!table.empty(), path, "has a header but no spheres");
  std::vector<Sphere>& spheres = file.scene.geometry.spheres;
  spheres.insert(spheres.end(), table.begin(), table.end());
}

}  // namespace

void SceneFile::refuse(const std::string& pointer, const std::string& why) const {
  throw located(*this, pointer, why);
}

SceneFile parse_scene(std::string text, const std::string& path) {
  SceneFile file{path, std::move(text), {}};
  const nlohmann::json root = parse_json(file.text, path);
  with_location(file, [&] {
    FieldReader reader(root);
    declare(reader, file.scene);
    reader.finish();
    if (file.scene.geometry.preset == Preset::throat) {
      place_throat(file.scene.geometry);
    }
  });
  if (!file.scene.geometry.spheres_file.empty()) {
    append_sphere_table(file);
  }
  with_location(file, [&] { check_scene(file.scene); });
  return file;
}

SceneFile read_scene(const std::string& path) {
  return parse_scene(read_text_file(path), path);
}

void check_starting_colloids(const SceneFile& file) {
  const std::vector<Body>& bodies = file.scene.geometry.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::string at = fmt::format("/geometry/bodies/{}", b);
    if (bodies[b].velocity) {
      file.refuse(
          at + "/velocity",
          "is prescribed, which can be measured (poreclog-solve measure); in a run "
          "nothing would stop the body at other surfaces: expected a force, or null");
    }
    const double own = 2.0 * bodies[b].sphere.radius;
    const double diameter = file.scene.colloids ? file.scene.colloids->diameter : own;
    if (std::abs(own - diameter) > 1e-9 * diameter) {
      file.refuse(at + "/diameter",
                  fmt::format("is {} m, but a run starts with colloids of "
                              "/colloids/diameter, {} m",
                              shortest(own), shortest(diameter)));
    }
  }
}

nlohmann::ordered_json to_json(Scene scene) {
  scene.geometry.spheres_file.clear();  // its spheres are listed
  nlohmann::ordered_json root = nlohmann::ordered_json::object();
  FieldWriter writer(root);
  declare(writer, scene);
  return root;
}

}  // namespace colloid
