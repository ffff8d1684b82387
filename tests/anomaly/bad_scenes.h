// Scenes that must be refused, and what the one message must say.  Run through the real
// program by tests/anomaly, through the reader and the JSON schema by tests/contract.
#pragma once

#include <string>
#include <vector>

namespace colloid {

struct BadScene {
  std::string text;
  int line;              ///< that the message must name
  std::string pointer;   ///< that the message must name
  std::string expected;  ///< what the message must say was expected, or near
  bool schema_knows;     ///< whether JSON Schema can refuse it too
};

/// A throat with a drive and one more member, on line 4.
inline std::string throat_with(const std::string& member) {
  return "{\n \"geometry\": {\"preset\": \"throat\"},\n"
         " \"drive\": {\"inlet_velocity\": \"0.5 mm/s\"},\n " +
         member + "}";
}

/// A box of 10 um with six faces (x- to z+; w, p, i, o, s for their conditions), more of
/// geometry on line 4 and more of the scene on line 5.
inline std::string box_with(const std::string& faces, const std::string& geometry = "",
                            const std::string& scene = "") {
  const std::vector<std::string> names{"x-", "x+", "y-", "y+", "z-", "z+"};
  std::string text = "{\"geometry\": {\n \"box\": [\"10 um\", \"10 um\", \"10 um\"],\n";
  text += " \"faces\": {";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char c = faces[i];
    const char* const word = c == 'w'   ? "wall"
                             : c == 'p' ? "periodic"
                             : c == 'i' ? "inlet"
                             : c == 'o' ? "outlet"
                                        : "symmetry";
    text += (i == 0 ? "\"" : ", \"") + names[i] + "\": \"" + word + "\"";
  }
  text += geometry.empty() ? "}\n" : "},\n " + geometry;
  text += scene.empty() ? "}}" : "},\n " + scene + "}";
  return text;
}

inline std::vector<BadScene> bad_keys_and_values() {
  return {
      // keys
      {throat_with(R"("fluid": {"viscocity": "1 mPa s"})"), 4, "/fluid/viscocity",
       "the nearest is \"viscosity\"", true},
      {throat_with(R"("cells_per_colloid": 8)"), 4, "/cells_per_colloid",
       "did you mean /fidelity/cells_per_colloid?", true},
      {throat_with(R"("colloids": {"diametre": "13.3 um"})"), 4, "/colloids/diametre",
       "the nearest is \"diameter\"", true},
      {throat_with(R"("colloids": {"density": "1050 kg/m^3"})"), 4, "/colloids",
       "has no key \"diameter\", which is required", true},
      {throat_with("\"a/b~\\n\": 1"), 4, "/a~1b~0\\u000a", "is not a known key", true},
      {R"({"fluid": {}})", 1, "/", "has no key \"geometry\"", true},
      {R"({"geometry": {}})", 1, "/geometry", "has no key \"box\"", true},
      {throat_with(R"("walls": "inert", "walls": "adhesive")"), 4, "/walls",
       "given twice, first on line 4", false},
      // units
      {throat_with(R"("duration": 5)"), 4, "/duration", "such as \"5 s\"", true},
      {throat_with(R"("duration": "5")"), 4, "/duration", "\"5\" has no unit", true},
      {throat_with(R"("duration": "5 um")"), 4, "/duration", "a unit of time", false},
      {throat_with(R"("duration": "5 seconds")"), 4, "/duration",
       "unknown symbol \"seconds\"", false},
      {throat_with(R"("duration": "NaN s")"), 4, "/duration",
       "does not begin with a finite number", true},
      {throat_with(R"("duration": "1e999 s")"), 4, "/duration", "range of a double",
       false},
      {throat_with(R"("gravity": ["0 m/s^2", "0 m/s^2"])"), 4, "/gravity",
       "a list of 3 quantities", true},
      {throat_with(R"("gravity": ["0 m/s^2", "0 m/s^2", -9.81])"), 4, "/gravity/2",
       "such as \"-9.81 m/s^2\"", true},
      {throat_with(R"("surface": {"primary_minimum": "computd"})"), 4,
       "/surface/primary_minimum", "the nearest is \"computed\"", true},
      {throat_with(R"("surface": {"hamaker": {"colloid_grain": "1e-20 J"}})"), 4,
       "/surface/hamaker", "has no key \"colloid_wall\"", true},
      // ranges
      {throat_with(R"("duration": "-5 s")"), 4, "/duration", "must be in (0, 1e+07] s",
       false},
      {throat_with(R"("duration": "0 s")"), 4, "/duration", "must be in (0, 1e+07] s",
       false},
      {throat_with(R"("surface": {"primary_minimum": "5 kT"})"), 4,
       "/surface/primary_minimum", "must be in [-1e-12, 0] J", false},
      {throat_with(R"("fluid": {"temperature": "0 K"})"), 4, "/fluid/temperature",
       "must be in [1, 1000] K", false},
      {throat_with(R"("fidelity": {"courant": 0})"), 4, "/fidelity/courant",
       "must be in (0, 1]", true},
      {throat_with(R"("fidelity": {"courant": 1.01})"), 4, "/fidelity/courant",
       "must be in (0, 1]", true},
      {throat_with(R"("fidelity": {"refinement": -1})"), 4, "/fidelity/refinement",
       "must be in [0, 6]", true},
      {throat_with(R"("fidelity": {"refinement": 18446744073709551615})"), 4,
       "/fidelity/refinement", "must be in [0, 6]", true},
      {throat_with(R"("fidelity": {"refinement": 18446744073709551616})"), 4,
       "/fidelity/refinement", "expected an integer in [0, 6]", true},
      {throat_with(R"("fidelity": {"cells_per_colloid": 1e999})"), 4,
       "/fidelity/cells_per_colloid", "range of a double", false},
      // types
      {throat_with(R"("fidelity": "auto")"), 4, "/fidelity", "expected an object", true},
      {throat_with(R"("fidelity": {"tier": 1})"), 4, "/fidelity/tier",
       "expected auto, one_way, quasi_steady or transient", true},
      {throat_with(R"("fidelity": {"courant": "0.3"})"), 4, "/fidelity/courant",
       "expected a number in (0, 1]", true},
      {throat_with(R"("fidelity": {"refinement": 1.5})"), 4, "/fidelity/refinement",
       "expected an integer", true},
      {throat_with(R"("aggregates": "yes")"), 4, "/aggregates", "expected true or false",
       true},
      {throat_with(R"("aggregates": null)"), 4, "/aggregates", "expected true or false",
       true},
      {throat_with(R"("description": 7)"), 4, "/description", "expected a text", true},
      {throat_with(R"("colloids": null)"), 4, "/colloids", "is null, expected an object",
       true},
      {R"([{"geometry": {"preset": "throat"}}])", 1, "/",
       "is a list of 1, expected an object", true},
      // choices
      {throat_with(R"("fidelity": {"tier": "oneway"})"), 4, "/fidelity/tier",
       "the nearest is \"one_way\"", true},
      {throat_with(R"("walls": "Inert")"), 4, "/walls", "the nearest is \"inert\"", true},
      {throat_with("\"bonds\": \"\\u0000\\n\""), 4, "/bonds", "permanent or breakable",
       true},
  };
}

inline std::vector<BadScene> bad_combinations() {
  const std::string pressure = R"("drive": {"pressure_drop": "1 Pa"})";
  return {
      // geometry
      {R"({"geometry": {"preset": "throat", "box": ["1 m", "1 m", "1 m"]}})", 1,
       "/geometry/box", "can only be given with a geometry without a preset", true},
      {R"({"geometry": {"box": ["1 m", "1 m", "1 m"], "height": "1 m"}})", 1,
       "/geometry/height", "can only be given with \"preset\": \"throat\"", true},
      {R"({"geometry": {"preset": "throat", "height": "90 um"},
           "drive": {"inlet_velocity": "1 mm/s"}})",
       1, "/geometry/height", "must be at least the collector diameter", false},
      {box_with("wwwwww", R"("spheres": {"center": 1})"), 4, "/geometry/spheres",
       "expected a list", true},
      {box_with("wwwwww", R"("spheres": [7])"), 4, "/geometry/spheres/0",
       "expected an object", true},
      {box_with(
           "wwwwww",
           R"("spheres": [{"center": ["0 m", "0 m", "17 um"], "diameter": "12 um"}])"),
       4, "/geometry/spheres/0", "is entirely outside the box", false},
      {box_with(
           "wwwwww",
           R"("spheres": [{"center": ["5 um", "5 um", "5 um"], "diameter": "18 um"}])"),
       1, "/geometry", "the grains fill the box", false},
      {box_with(
           "wwwwoi",
           R"("spheres": [{"center": ["5 um", "5 um", "10 um"], "diameter": "15 um"}])",
           pressure),
       1, "/geometry", "the grains cover the inlet z+", false},
      {box_with("wwwwww", R"("spheres_file": "/nowhere/pack.csv")"), 4,
       "/geometry/spheres_file", "there is no file /nowhere/pack.csv", false},
      // faces
      {box_with("pwwwww"), 3, "/geometry/faces/x+", "expected both or none", false},
      {box_with("wwwpww"), 3, "/geometry/faces/y-", "expected both or none", false},
      {box_with("iowwwi"), 3, "/geometry/faces/z+",
       "is a second inlet, x- is one already", false},
      {box_with("wwwwwi", "", pressure), 3, "/geometry/faces/z+", "no face is an outlet",
       false},
      {box_with("wowwwi", "", pressure), 3, "/geometry/faces/x+",
       "expected it opposite to the inlet z+", false},
      // drives
      {R"({"geometry": {"preset": "throat"},
           "drive": {"inlet_velocity": "1 mm/s", "pressure_drop": "1 Pa"}})",
       2, "/drive", "expected exactly one: inlet_velocity,", true},
      {R"({"geometry": {"preset": "throat"}, "drive": {}})", 1, "/drive",
       "expected exactly one: inlet_velocity,", true},
      {R"({"geometry": {"preset": "throat"}})", 1, "/drive",
       "expected inlet_velocity or pressure_drop", false},
      {R"({"geometry": {"preset": "throat"}, "drive": {"inlet_velocity": "-1 mm/s"}})", 1,
       "/drive/inlet_velocity", "must be in (0, 100] m/s", false},
      {box_with("wwwwww", "", R"("drive": {"inlet_velocity": "1 mm/s"})"), 5,
       "/drive/inlet_velocity", "needs an inlet face", false},
      {box_with("wwwwow", "", pressure), 5, "/drive/pressure_drop", "needs an inlet face",
       false},
      {box_with("wwwwpp", "",
                R"("drive": {"mean_velocity": ["1 m/s", "0 m/s", "0 m/s"]})"),
       5, "/drive/mean_velocity/0", "must be 0 m/s", false},
      {box_with("wwwwww", "",
                R"("drive": {"mean_velocity": ["0 m/s", "0 m/s", "0 m/s"]})"),
       5, "/drive/mean_velocity", "needs a pair of periodic faces", false},
      {box_with("ppppws", "", R"("drive": {"shear_rate": "1 1/s"})"), 5,
       "/drive/shear_rate", "needs walls at z- and z+, but z+ is symmetry", false},
      {box_with("wwppww", "", R"("drive": {"shear_rate": "1 1/s"})"), 5,
       "/drive/shear_rate", "needs periodic faces x- and x+", false},
      {box_with("wwwwoi", "",
                R"("drive": {"body_force": ["0 N/m^3", "0 N/m^3", "1 N/m^3"]})"),
       5, "/drive", "expected inlet_velocity or pressure_drop", false},
      // colloids and bodies
      {throat_with(R"("colloids": {"diameter": "96.6 um"})"), 4, "/colloids/diameter",
       "must be below the width of the inlet, 9.66e-05 m", false},
      {box_with(
           "wwwwww",
           R"("bodies": [{"center": ["5 um", "5 um", "1 um"], "diameter": "3 um"}])"),
       4, "/geometry/bodies/0", "sticks out of the box by 5", false},
      {box_with("wwwwww",
                R"("bodies": [{"center": ["5 um", "5 um", "3 um"], "diameter": "4 um"},
                              {"center": ["5 um", "5 um", "6 um"], "diameter": "4 um"}])"),
       5, "/geometry/bodies/1", "overlaps /geometry/bodies/0", false},
      {box_with("wwwwww",
                R"("spheres": [{"center": ["5 um", "5 um", "5 um"], "diameter": "4 um"}],
                   "bodies": [{"center": ["5 um", "5 um", "8 um"], "diameter": "4 um"}])"),
       5, "/geometry/bodies/0", "overlaps grain 0", false},
      {box_with("wwwwww",
                R"("bodies": [{"center": ["5 um", "5 um", "5 um"], "diameter": "4 um",
                               "velocity": ["1 um/s", "0 m/s", "0 m/s"]}])",
                R"("fidelity": {"tier": "one_way"})"),
       6, "/fidelity/tier", "need quasi_steady or transient", false},
  };
}

/// Texts that are no JSON, where only line and reason can be named.
inline std::vector<BadScene> bad_texts() {
  return {
      {throat_with(R"("duration": NaN)"), 4, "", "NaN is not a JSON number", true},
      {throat_with(R"("duration": -Infinity)"), 4, "", "-Infinity is not a JSON number",
       true},
      {throat_with(R"("duration": "5 s",)"), 4, "", "a comma before a closing bracket",
       true},
      {throat_with("// five seconds"), 4, "", "JSON has no comments", true},
      {"{\n\"geometry\": {\"preset\"", 2, "", "the text ends in the middle", true},
      {std::string(100000, '['), 1, "", "nested more than 32 levels", true},
      {"{\n\"geometry\": \"\xFF\"}", 2, "", "is not UTF-8 text (byte 0xff)", true},
      {"<?xml version=\"1.0\"?>", 1, "", "is not JSON", true},
  };
}

}  // namespace colloid
