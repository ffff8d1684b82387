// Scene files in, scenes out.  A scene that is not understood in full is refused with one
// message: file, line and column, JSON pointer, what is there and what was expected.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace colloid {

/// A scene together with the text it came from, so that a later refusal (a tier that
/// cannot do it, say) can still name the line.
struct SceneFile {
  std::string path;
  std::string text;
  Scene scene;

  /// Throws the InputError for the value at `pointer`.
  [[noreturn]] void refuse(const std::string& pointer, const std::string& why) const;
};

/// Reads, completes (preset, spheres_file) and checks the scene at `path`.
SceneFile read_scene(const std::string& path);

/// The same for JSON text; `path` names it in messages and anchors spheres_file.
SceneFile parse_scene(std::string text, const std::string& path);

/// Refuses bodies with which a run cannot start: it takes them for colloids that are
/// there from the beginning.
void check_starting_colloids(const SceneFile& file);

/// The scene with every default spelled out, quantities in SI with all digits, spheres of
/// spheres_file listed: reading it gives the same scene, bit for bit.
nlohmann::ordered_json to_json(Scene scene);

}  // namespace colloid
