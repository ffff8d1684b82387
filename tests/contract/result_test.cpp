// A result file as the program writes it, against schemas/result.md in both directions
// and against the values that went in, both read by a reader that shares nothing with the
// writer (h5py).  The names below are spelled a second time on purpose: a column under
// the wrong name would come back right through our own reader.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "io/content_hash.h"
#include "io/result_file.h"
#include "realisation_example.h"
#include "temporary_folder.h"

namespace colloid {
namespace {

using nlohmann::json;

json to_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

struct Output {
  int exit_code;
  std::string text;
};

/// A script of the project under the interpreter that has Debian's h5py.
Output run_script(const std::string& script, const std::string& arguments,
                  const TemporaryFolder& folder) {
  const std::string out = folder.file("out");
  const std::string command = "timeout 60 " PORECLOG_PYTHON " " PORECLOG_SOURCE_DIR "/" +
                              script + " " + arguments + " >" + out + " 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out)};
}

Provenance example_provenance() {
  return {"0.9",
          "c0ffee",
          "GNU 1",
          "-O7",
          "1.2.3",
          "anna",
          "node7",
          "Z80",
          3,
          "a 'b c'",
          "2001-02-03T04:05:06Z"};
}

void put_root(json& values, const Realisation& r) {
  values["/@complete"] = 1;
  values["/@schema_version"] = ResultFile::kSchemaVersion;
  values["/@tier"] = r.tier;
  values["/@tier_reason"] = r.tier_reason;
  values["/@ending"] = r.ending == Ending::clogged ? "clogged" : "duration";
  values["/@seed"] = std::to_string(r.seed);
  values["/@seed_uint64"] = r.seed;
  values["/@duration_s"] = r.duration;
  values["/@t1_s"] = r.t1;
  values["/@tc_s"] = r.tc;
  values["/@alpha_deg"] = r.alpha_deg;
  values["/@last_traversal_s"] = r.last_traversal;
  values["/@blocked_since_s"] = r.blocked_since;
  values["/@injected"] = r.counts.injected;
  values["/@delayed"] = r.counts.delayed;
  values["/@mobile"] = r.counts.mobile;
  values["/@bonded"] = r.counts.bonded;
  values["/@retained"] = r.counts.retained;
  values["/@traversed"] = r.counts.traversed;
  for (const auto& [name, value] : r.deterministic) {
    values["/solver@" + name] = value;
  }
  for (const auto& [name, value] : r.cost) {
    values["/solver/cost@" + name] = value;
  }
}

void put_provenance(json& values, const Provenance& p, const Scene& scene) {
  values["/provenance@version"] = p.version;
  values["/provenance@commit"] = p.commit;
  values["/provenance@compiler"] = p.compiler;
  values["/provenance@compiler_flags"] = p.compiler_flags;
  values["/provenance@hdf5_version"] = p.hdf5_version;
  values["/provenance@user"] = p.user;
  values["/provenance@hostname"] = p.hostname;
  values["/provenance@cpu_model"] = p.cpu_model;
  values["/provenance@cores"] = p.cores;
  values["/provenance@command_line"] = p.command_line;
  values["/provenance@start_time"] = p.start_time;
  values["/provenance@scene_hash"] = scene_hash(scene);
  values["/provenance/scene"] = scene_text(scene);
  values["/h5md@version"] = {1, 1};
  values["/h5md/author@name"] = p.user;
  values["/h5md/creator@name"] = "poreclog";
  values["/h5md/creator@version"] = p.version;
  values["/h5md/modules/units@version"] = {1, 0};
  values["/h5md/modules/units@system"] = "SI";
}

/// The box [0, d_c]^2 x [0, 1.5 d_c] of the throat and whatever grains it has.
void put_geometry(json& values, const Scene& scene) {
  for (const std::string group : {"/particles/colloids", "/particles/grains"}) {
    values[group + "/box@dimension"] = 3;
    values[group + "/box@boundary"] = {"none", "none", "none"};
    values[group + "/box/edges"] = to_json(scene.geometry.box.size);
  }
  for (const Sphere& grain : scene.geometry.spheres) {
    values["/particles/grains/position"].push_back(to_json(grain.center));
    values["/particles/grains/diameter"].push_back(2.0 * grain.radius);
  }
}

void put_series(json& values, const Realisation& realisation) {
  for (const SeriesRow& row : realisation.series) {
    values["/series/time_s"].push_back(row.time);
    values["/series/critical_diameter_m"].push_back(row.critical_diameter);
    values["/series/permeability_m2"].push_back(row.permeability);
    values["/series/permeability_ratio"].push_back(row.permeability_ratio);
    values["/series/injected"].push_back(row.injected);
    values["/series/delayed"].push_back(row.delayed);
    values["/series/mobile"].push_back(row.mobile);
    values["/series/bonded"].push_back(row.bonded);
    values["/series/retained"].push_back(row.retained);
    values["/series/first_layer"].push_back(row.first_layer);
    values["/series/multilayer"].push_back(row.multilayer);
    values["/series/wall_layer"].push_back(row.wall_layer);
    values["/series/traversed"].push_back(row.traversed);
  }
}

std::string list_text(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  return text;
}

void put_retained(json& values, const Realisation& realisation) {
  const char* const layers[] = {"first", "multilayer", "wall"};
  const char* const mechanisms[] = {"attachment_to_grain", "attachment_to_deposit",
                                    "attachment_to_wall", "straining"};
  for (const RetainedColloid& one : realisation.retained) {
    values["/retained/order"].push_back(one.order);
    values["/retained/colloid"].push_back(one.colloid);
    values["/retained/time_s"].push_back(one.time);
    values["/retained/contact_time_s"].push_back(one.contact_time);
    values["/retained/position_m"].push_back(to_json(one.position));
    values["/retained/layer"].push_back(layers[static_cast<int>(one.layer)]);
    values["/retained/mechanism"].push_back(mechanisms[static_cast<int>(one.mechanism)]);
    values["/retained/injection_position_m"].push_back(to_json(one.injection_position));
    values["/retained/injection_time_s"].push_back(one.injection_time);
    values["/retained/alpha_deg"].push_back(one.alpha_deg);
    values["/retained/partners"].push_back(list_text(one.partners));
    values["/retained/bond_load_N"].push_back(one.bond_load);
    values["/retained/bond_overloaded"].push_back(one.bond_overloaded);
  }
  for (const InjectionRecord& one : realisation.injections) {
    values["/injections/index"].push_back(one.index);
    values["/injections/volume_m3"].push_back(one.volume);
    values["/injections/time_s"].push_back(one.time);
    values["/injections/position_m"].push_back(to_json(one.position));
  }
}

void put_frames(json& values, const Realisation& realisation) {
  const char* const states[] = {"absent",   "mobile",    "bonded",
                                "retained", "traversed", "delayed"};
  const std::string colloids = "/particles/colloids/";
  std::size_t places = 0;
  for (const Frame& frame : realisation.frames) {
    places = std::max(places, frame.colloids.size());
  }
  for (const Frame& frame : realisation.frames) {
    for (const char* element : {"position", "velocity", "id", "diameter", "state"}) {
      values[colloids + element + "/step"].push_back(frame.step);
      values[colloids + element + "/time"].push_back(frame.time);
    }
    json position = json::array();
    json velocity = json::array();
    json id = json::array();
    json diameter = json::array();
    json state = json::array();
    for (const ColloidRecord& one : frame.colloids) {
      position.push_back(to_json(one.position));
      velocity.push_back(to_json(one.velocity));
      id.push_back(one.id);
      diameter.push_back(one.diameter);
      state.push_back(states[static_cast<int>(one.state)]);
    }
    while (id.size() < places) {
      position.push_back({nullptr, nullptr, nullptr});
      velocity.push_back({nullptr, nullptr, nullptr});
      id.push_back(-1);
      diameter.push_back(nullptr);
      state.push_back("absent");
    }
    values[colloids + "position/value"].push_back(position);
    values[colloids + "velocity/value"].push_back(velocity);
    values[colloids + "id/value"].push_back(id);
    values[colloids + "diameter/value"].push_back(diameter);
    values[colloids + "state/value"].push_back(state);
  }
}

TEST(ResultContract, FileAndDocumentAgreeOnEveryNameTypeUnitAndValue) {
  const TemporaryFolder folder;
  const Scene scene = throat_scene();
  const Realisation realisation = example_realisation(20);
  ResultFile(folder.file("r.h5"), example_provenance(), scene).finish(realisation);

  json values;
  put_root(values, realisation);
  put_provenance(values, example_provenance(), scene);
  put_geometry(values, scene);
  put_series(values, realisation);
  put_retained(values, realisation);
  put_frames(values, realisation);
  write_bytes(folder.file("values.json"), values.dump());

  const Output output =
      run_script("tests/contract/result_layout.py",
                 folder.file("r.h5") + " " PORECLOG_SOURCE_DIR "/schemas/result.md " +
                     folder.file("values.json"),
                 folder);
  EXPECT_EQ(output.exit_code, 0) << output.text;
  EXPECT_EQ(output.text, "\n");
}

TEST(ResultContract, BecomesFilesForParaView) {
  const TemporaryFolder folder;
  const std::string result = folder.file("r.h5");
  const std::string vtk = folder.file("new/vtk");
  Realisation realisation = example_realisation();
  realisation.frames.back().colloids.back().velocity.x = kNotYet;
  realisation.frames.back().colloids.back().state = ColloidState::mobile;
  ResultFile(result, example_provenance(), throat_scene()).finish(realisation);
  const Output written =
      run_script("scripts/result_to_vtk.py", result + " " + vtk, folder);
  ASSERT_EQ(written.exit_code, 0) << written.text;
  EXPECT_EQ(written.text, "7 frames: open " + vtk + "/colloids.pvd in ParaView\n");
  const Output compared =
      run_script("tests/contract/vtk_files.py", result + " " + vtk, folder);
  EXPECT_EQ(compared.exit_code, 0) << compared.text;
}

TEST(ResultContract, NothingUnfinishedBecomesFilesForParaView) {
  const TemporaryFolder folder;
  const ResultFile file(folder.file("r.h5"), example_provenance(), throat_scene());
  const std::string vtk = folder.file("vtk");
  for (const std::string& path : {file.part_path(), folder.file("none.h5")}) {
    const Output output =
        run_script("scripts/result_to_vtk.py", path + " " + vtk, folder);
    EXPECT_EQ(output.exit_code, 2) << output.text;
    EXPECT_EQ(output.text.rfind("result_to_vtk.py: " + path + ": ", 0), 0U)
        << output.text;
    EXPECT_FALSE(std::filesystem::exists(vtk));
  }
}

}  // namespace
}  // namespace colloid
