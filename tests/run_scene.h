// A small pore that clogs in a second of computing: for tests of `poreclog-solve run`.
#pragma once

#include <string>

#include "program.h"

namespace colloid {

/// The throat with colloids half its size, three cells each, in a dense suspension.
inline std::string clogging_scene(const std::string& duration = "1 s",
                                  const std::string& more = "") {
  return R"({"geometry": {"preset": "throat", "height": "120 um"},
 "drive": {"inlet_velocity": "0.5 mm/s"},
 "colloids": {"diameter": "20 um", "density": "1050 kg/m^3", "volume_fraction": 0.05},
 "duration": ")" +
         duration + R"(", )" + more + R"(
 "fidelity": {"tier": "one_way", "cells_per_colloid": 3, "hindrance": "wall",
              "capture_gap": "200 nm"}})";
}

/// The scene by another tier.
inline std::string in_tier(std::string scene, const std::string& tier) {
  return scene.replace(scene.find("one_way"), 7, tier);
}

/// Runs a Python script of the tests with Debian's python3, to which h5py belongs.
inline int run_python(const std::string& script, const std::string& arguments) {
  const std::string command = PORECLOG_PYTHON " " PORECLOG_SOURCE_DIR "/tests/" + script +
                              " " + arguments + " >&2";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace colloid
