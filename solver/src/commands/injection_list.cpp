#include "commands/injection_list.h"

#include <cmath>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "core/text.h"
#include "scene/read_scene.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLongestList = 1e6;
constexpr const char* kTimeFrom = "volume over the flow rate of the clean pore";

InjectionList list_injections(const Scene& scene, std::uint64_t seed) {
  InjectionList list;
  list.seed = seed;
  list.duration = scene.duration;
  list.inlet = clean_inlet(scene);
  InjectionSequence sequence(make_injection_plan(scene, list.inlet.capture_gap), seed);
  const InjectionPlan& plan = sequence.plan();
  list.inlet_area = plan.inlet_area;
  list.mean_rate = plan.volume_fraction * list.inlet.flow_rate /
                   (4.0 / 3.0 * kPi * std::pow(plan.colloid_radius, 3));
  const double expected = list.mean_rate * list.duration;
  require(expected <= kLongestList, "/duration",
          fmt::format("is {} s, in which {:.3g} colloids enter; expected at most {:g} in "
                      "a list",
                      shortest(list.duration), expected, kLongestList));
  const double end = list.inlet.flow_rate * list.duration;
  for (const Body& body : scene.geometry.bodies) {
    list.colloids.push_back(
        {static_cast<int>(list.colloids.size()), 0.0, body.sphere.center});
  }
  const int present = static_cast<int>(list.colloids.size());
  for (int i = 0; sequence.at(i).volume <= end; ++i) {
    list.colloids.push_back(sequence.at(i));
    list.colloids.back().index += present;
  }
  return list;
}

}  // namespace

InjectionList list_injections(const std::string& path, std::uint64_t seed) {
  const SceneFile file = read_scene(path);
  check_starting_colloids(file);
  try {
    return list_injections(file.scene, seed);
  } catch (const InputError& error) {
    file.refuse(error.where(), error.why());  // the same with file and line
  }
}

Json injections_json(const InjectionList& list) {
  Json out{{"seed", std::to_string(list.seed)},
           {"duration_s", list.duration},
           {"flow_rate_m3_s", list.inlet.flow_rate},
           {"inlet_area_m2", list.inlet_area},
           {"capture_gap_m", list.inlet.capture_gap},
           {"mean_rate_per_s", list.mean_rate},
           {"time_from", kTimeFrom},
           {"injections", Json::array()}};
  for (const InjectedColloid& colloid : list.colloids) {
    const auto [x, y, z] = colloid.position;
    out["injections"].push_back({{"index", colloid.index},
                                 {"volume_m3", colloid.volume},
                                 {"time_s", list.time_of(colloid)},
                                 {"position_m", {x, y, z}},
                                 {"redraws", colloid.redraws}});
  }
  return out;
}

std::string injections_table(const InjectionList& list) {
  std::string out = fmt::format(
      "seed         {}\n"
      "flow rate    {:.6g} m^3/s of the clean pore\n"
      "capture gap  {:.4g} m\n"
      "mean rate    {:.6g} colloids per second\n"
      "colloids     {} in {:g} s; their time is the {}\n\n"
      "{:>7}  {:>12}  {:>10}  {:>10}  {:>10}  {:>10}\n",
      list.seed, list.inlet.flow_rate, list.inlet.capture_gap, list.mean_rate,
      list.colloids.size(), list.duration, kTimeFrom, "index", "volume [m3]", "time [s]",
      "x [m]", "y [m]", "z [m]");
  for (const InjectedColloid& colloid : list.colloids) {
    out += fmt::format("{:>7}  {:>12.6g}  {:>10.6g}  {:>10.5g}  {:>10.5g}  {:>10.5g}\n",
                       colloid.index, colloid.volume, list.time_of(colloid),
                       colloid.position.x, colloid.position.y, colloid.position.z);
  }
  return out;
}

}  // namespace colloid
