#include "report/scene_facts.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace colloid {

namespace {

using nlohmann::json;

/// The number in "1.33e-05 m"; none if there is no such key or it holds another word.
std::optional<double> quantity(const json& scene, const char* pointer) {
  const json::json_pointer place(pointer);
  if (!scene.contains(place)) {
    return std::nullopt;
  }
  const json& value = scene.at(place);
  if (value.is_number()) {
    return value.get<double>();
  }
  if (!value.is_string()) {
    return std::nullopt;
  }
  const auto text = value.get<std::string>();
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return end == text.c_str() || !std::isfinite(number) ? std::nullopt
                                                       : std::optional(number);
}

std::string word(const json& scene, const char* pointer) {
  const json::json_pointer place(pointer);
  return scene.contains(place) && scene.at(place).is_string()
             ? scene.at(place).get<std::string>()
             : "";
}

std::optional<statistics::Section> inlet_of(const json& scene) {
  std::optional<double> x;
  std::optional<double> y;
  if (word(scene, "/geometry/preset") == "throat") {
    x = quantity(scene, "/geometry/collector_diameter");
    y = x;
  } else if (word(scene, "/geometry/faces/z+") == "inlet" ||
             word(scene, "/geometry/faces/z-") == "inlet") {
    x = quantity(scene, "/geometry/box/0");
    y = quantity(scene, "/geometry/box/1");
  }
  return x && y ? std::optional(statistics::Section{{0.0, *x}, {0.0, *y}}) : std::nullopt;
}

}  // namespace

SceneFacts scene_facts(const json& scene) {
  SceneFacts facts;
  facts.duration = quantity(scene, "/duration");
  facts.colloid_diameter = quantity(scene, "/colloids/diameter");
  facts.inlet = inlet_of(scene);
  facts.inlet_margin = 0.5 * facts.colloid_diameter.value_or(0.0) +
                       quantity(scene, "/fidelity/capture_gap").value_or(0.0);
  facts.stops_when_clogged = word(scene, "/stop_when") == "clogged";
  return facts;
}

}  // namespace colloid
