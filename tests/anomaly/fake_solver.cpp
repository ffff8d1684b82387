// Stands in for poreclog-solve where the orchestrator is tested: the same command line
// and the same result file, made from the seed alone in a few milliseconds; and, asked by
// environment variables, every fault a solver can have.
//
//   FAKE_FAULT        hang | ignore_term | crash | abort_exit | not_converged | refuse |
//                     nonsense | no_file | torn | incomplete | foreign_seed |
//                     foreign_scene | foreign_tier | random_result | exit_5
//   FAKE_ATTEMPTS     the fault befalls the first so many attempts of a realisation only
//   FAKE_ONE_IN       and only seeds that this number divides
//   FAKE_SECONDS      how long it takes (default 0)
//   FAKE_ROWS         rows of the series (default 100)
//   FAKE_CHANGE       what is one more than the seed says: @ATTRIBUTE, or COLUMN (last
//   row)
//
// fake_solver fill SCENE FOLDER writes many results at once.
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <hdf5.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {

using nlohmann::json;

volatile std::sig_atomic_t stop_requested = 0;

void request_stop(int) {
  stop_requested = 1;
}

std::string environment(const char* name, const std::string& otherwise = "") {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : value;
}

/// Steele, Lea & Flood (2014): a stream of 64-bit numbers from a seed.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

struct Arguments {
  std::string scene;
  std::string result;
  std::string checkpoint;
  std::uint64_t seed = 0;
};

bool has_fault(const Arguments& arguments) {
  const std::string folder = std::filesystem::current_path().filename().string();
  const int attempt =
      folder.rfind("attempt-", 0) == 0 ? std::atoi(folder.c_str() + 8) : 1;
  const int attempts = std::atoi(environment("FAKE_ATTEMPTS", "1000000").c_str());
  const auto one_in = std::stoull(environment("FAKE_ONE_IN", "1"));
  return !environment("FAKE_FAULT").empty() && attempt <= attempts &&
         arguments.seed % one_in == 0;
}

[[noreturn]] void hang() {
  for (;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (stop_requested != 0) {
      std::exit(5);
    }
  }
}

bool is_changed(const std::string& name) {
  static const std::string changed = environment("FAKE_CHANGE");
  return name == changed;
}

void put_number(hid_t object, const char* name, double value) {
  value += is_changed(std::string("@") + name) ? 1.0 : 0.0;
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute =
      H5Acreate2(object, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
  H5Aclose(attribute);
  H5Sclose(space);
}

hid_t text_type(std::size_t length) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max(length, std::size_t{1}));
  return type;
}

void put_text(hid_t object, const char* name, const std::string& text) {
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t type = text_type(text.size());
  const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, text.data());
  H5Aclose(attribute);
  H5Tclose(type);
  H5Sclose(space);
}

void put_scene(hid_t group, const std::string& text) {
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t type = text_type(text.size());
  const hid_t set =
      H5Dcreate2(group, "scene", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
  H5Dclose(set);
  H5Tclose(type);
  H5Sclose(space);
}

void put_column(hid_t group, const char* name, std::vector<double> values,
                hsize_t width = 1) {
  if (is_changed(name)) {
    values.at(values.size() - 1) += 1.0;
  }
  const std::array<hsize_t, 2> shape{values.size() / width, width};
  const hid_t space = H5Screate_simple(width == 1 ? 1 : 2, shape.data(), nullptr);
  const hid_t set = H5Dcreate2(group, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                               H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(set);
  H5Sclose(space);
}

/// An enumeration with these words, as the solver writes layers and mechanisms.
void put_words(hid_t group, const char* name, const std::vector<std::int8_t>& values,
               const std::vector<const char*>& words) {
  const hid_t type = H5Tenum_create(H5T_NATIVE_INT8);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = static_cast<std::int8_t>(i);
    H5Tenum_insert(type, words[i], &value);
  }
  const hsize_t rows = values.size();
  const hid_t space = H5Screate_simple(1, &rows, nullptr);
  const hid_t set =
      H5Dcreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(set);
  H5Sclose(space);
  H5Tclose(type);
}

/// What happens in the made-up realisation: times of retention, and where it ends.
struct Story {
  std::vector<double> retention;  ///< [s]
  double t1;
  double tc;  ///< NaN: never
};

Story story_of(SplitMix& random) {
  Story story{{}, 0.0, std::numeric_limits<double>::quiet_NaN()};
  const double rate = 4.0 + 8.0 * random.uniform();  // [1/s]
  for (double t = -std::log(1.0 - random.uniform()) / rate; t < 5.0;
       t -= std::log(1.0 - random.uniform()) / rate) {
    story.retention.push_back(t);
  }
  story.t1 = story.retention.empty() ? std::numeric_limits<double>::quiet_NaN()
                                     : story.retention.front();
  if (story.retention.size() > 30) {
    story.tc = story.retention[30];
  }
  return story;
}

void write_series(hid_t file, const Story& story) {
  const int rows = std::atoi(environment("FAKE_ROWS", "100").c_str());
  std::vector<double> time;
  std::vector<double> diameter;
  std::vector<double> ratio;
  for (int k = 0; k < rows; ++k) {
    time.push_back(5.0 * k / std::max(1, rows - 1));
    double count = 0.0;
    for (const double t : story.retention) {
      count += t <= time.back() ? 1.0 : 0.0;
    }
    diameter.push_back(4.0e-5 * std::exp(-count / 20.0));
    ratio.push_back(std::exp(-count / 10.0));
  }
  const hid_t group = H5Gcreate2(file, "series", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  put_column(group, "time_s", time);
  put_column(group, "critical_diameter_m", diameter);
  put_column(group, "permeability_ratio", ratio);
  H5Gclose(group);
}

void write_retained(hid_t file, const Story& story, SplitMix& random) {
  const hid_t group = H5Gcreate2(file, "retained", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const std::size_t rows = story.retention.size();
  std::vector<double> order;
  std::vector<double> contact;
  std::vector<double> position;
  std::vector<double> injection;
  std::vector<double> injected;
  std::vector<double> alpha;
  std::vector<std::int8_t> layer;
  for (std::size_t i = 0; i < rows; ++i) {
    order.push_back(static_cast<double>(i + 1));
    contact.push_back(story.retention[i] - 0.001);
    injected.push_back(story.retention[i] - 0.1);
    alpha.push_back(90.0 * random.uniform());
    layer.push_back(static_cast<std::int8_t>(i % 2));
    for (int axis = 0; axis < 3; ++axis) {
      position.push_back(1e-4 * random.uniform());
      injection.push_back(1e-4 * random.uniform());
    }
  }
  put_column(group, "order", order);
  put_column(group, "colloid", order);
  put_column(group, "time_s", story.retention);
  put_column(group, "contact_time_s", contact);
  put_column(group, "position_m", position, 3);
  put_column(group, "injection_position_m", injection, 3);
  put_column(group, "injection_time_s", injected);
  put_column(group, "alpha_deg", alpha);
  put_column(group, "bond_load_N", contact);
  put_words(group, "layer", layer, {"first", "multilayer", "wall"});
  put_words(group, "mechanism", layer, {"attachment_to_grain", "attachment_to_deposit"});
  H5Gclose(group);
}

void write_result(const Arguments& arguments, const json& scene) {
  const std::string fault = has_fault(arguments) ? environment("FAKE_FAULT") : "";
  const std::uint64_t seed = arguments.seed + (fault == "foreign_seed" ? 1 : 0);
  SplitMix random(fault == "random_result" ? static_cast<std::uint64_t>(::getpid())
                                           : seed);
  const Story story = story_of(random);
  const std::string part = arguments.result + ".part";
  const hid_t file = H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (file < 0) {
    std::cerr << "fake solver: cannot write " << part << "\n";
    std::exit(4);
  }
  const hid_t provenance =
      H5Gcreate2(file, "provenance", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  put_text(provenance, "version", "0.0.0-fake");
  put_text(provenance, "commit", "none");
  json own = scene;
  own["foreign"] = fault == "foreign_scene";
  if (!own["foreign"].get<bool>()) {
    own.erase("foreign");
  }
  put_scene(provenance, own.dump());
  H5Gclose(provenance);
  put_text(file, "tier",
           fault == "foreign_tier" ? "elsewhere"
                                   : scene.at("fidelity").at("tier").get<std::string>());
  put_text(file, "ending", std::isnan(story.tc) ? "duration" : "clogged");
  put_text(file, "seed", std::to_string(seed));
  put_number(file, "duration_s", 5.0);
  put_number(file, "t1_s", story.t1);
  put_number(file, "tc_s", story.tc);
  put_number(file, "alpha_deg", 90.0 * random.uniform());
  put_number(file, "last_traversal_s", 4.9);
  put_number(file, "injected", 95.0);
  put_number(file, "traversed", 95.0 - static_cast<double>(story.retention.size()));
  write_series(file, story);
  write_retained(file, story, random);
  put_number(file, "complete", fault == "incomplete" ? 0.0 : 1.0);
  const bool written = H5Fclose(file) >= 0;
  if (fault == "torn") {
    std::filesystem::resize_file(part, std::filesystem::file_size(part) / 2);
  }
  if (!written || std::rename(part.c_str(), arguments.result.c_str()) != 0) {
    std::remove(part.c_str());
    std::cerr << "fake solver: cannot write " << arguments.result << "\n";
    std::exit(4);
  }
}

int suffer(const std::string& fault) {
  if (fault == "hang") {
    hang();
  }
  if (fault == "ignore_term") {
    std::signal(SIGTERM, SIG_IGN);
    hang();
  }
  if (fault == "crash") {
    std::raise(SIGSEGV);
  }
  if (fault == "nonsense") {
    for (int i = 0; i < 20000; ++i) {
      std::cout << "\xff\xfe nonsense \x1b[31m</script>\n";
      std::cerr << "\xff\xfe';DROP TABLE realisation;--\n";
    }
    return 77;
  }
  std::cerr << "fake solver: " << fault << " as asked\n";
  return fault == "abort_exit"      ? 4
         : fault == "not_converged" ? 3
         : fault == "refuse"        ? 2
         : fault == "exit_5"        ? 5
         : fault == "no_file"       ? 0
                                    : -1;
}

/// Writes the attempts of many realisations at once, for measurements of scale: stdin has
/// lines "index seed", `folder` is the ensemble's.
int fill(const std::string& scene_file, const std::string& folder) {
  const json scene = json::parse(std::ifstream(scene_file));
  Arguments arguments;
  for (int index = 0; std::cin >> index >> arguments.seed;) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "/%06d/attempt-001/", index);
    const std::string attempt = folder + name.data();
    std::filesystem::create_directories(attempt);
    arguments.result = attempt + "result.h5";
    write_result(arguments, scene);
    std::ofstream(attempt + "command") << "fill\n";
    std::ofstream(attempt + "ending.json")
        << R"({"exit_code": 0, "wall_s": 1.0, "cpu_s": 1.0, "node": "n"})";
  }
  return 0;
}

/// Takes its time in steps, which a checkpoint counts.
int compute(const Arguments& arguments) {
  constexpr int kSteps = 20;
  const double seconds = std::atof(environment("FAKE_SECONDS", "0").c_str());
  int step = 0;
  std::ifstream(arguments.checkpoint) >> step;
  for (; step < kSteps && seconds > 0.0; ++step) {
    if (stop_requested != 0) {
      const std::string part = arguments.checkpoint + ".part";
      std::ofstream(part) << step;
      std::rename(part.c_str(), arguments.checkpoint.c_str());
      return 5;
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds / kSteps));
  }
  return 0;
}

int run(const Arguments& arguments) {
  std::signal(SIGTERM, request_stop);
  if (has_fault(arguments)) {
    const int exit_code = suffer(environment("FAKE_FAULT"));
    if (exit_code >= 0) {
      return exit_code;
    }
  }
  const int exit_code = compute(arguments);
  if (exit_code == 0) {
    write_result(arguments, json::parse(std::ifstream(arguments.scene)));
  }
  return exit_code;
}

/// Fills in defaults and refuses keys it does not know, as the solver does.
int describe(const std::string& path, bool regime) {
  json scene = json::parse(std::ifstream(path));
  json full{{"description", ""},
            {"duration", "5 s"},
            {"colloids", {{"diameter", "1e-05 m"}, {"density", "1050 kg/m^3"}}},
            {"fidelity", {{"tier", "one_way"}, {"cells_per_colloid", 5.5}}}};
  for (const auto& [key, value] : scene.items()) {
    if (!full.contains(key)) {
      std::cerr << "poreclog-solve: " << path << " line 1, column 1: /" << key
                << ": is not a known key here\n";
      return 2;
    }
  }
  full.merge_patch(scene);
  const json answer{{"schema_version", 1},
                    {"regime",
                     {{"models", {{"gravity", true}}},
                      {"reasons", {{"gravity", "settling/U = 0.01 > 0.001"}}}}}};
  std::cout << (regime ? answer : full).dump(2) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "fill") {
    return fill(words[1], words[2]);
  }
  Arguments arguments;
  bool regime = false;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto value = [&] { return i + 1 < words.size() ? words[++i] : ""; };
    if (words[i] == "-o") {
      arguments.result = value();
    } else if (words[i] == "--seed") {
      arguments.seed = std::stoull(value());
    } else if (words[i] == "--checkpoint") {
      arguments.checkpoint = value();
    } else if (words[i] == "--checkpoint-interval") {
      value();
    } else if (words[i] == "--regime") {
      regime = true;
      arguments.scene = value();
    } else if (words[i] == "--scene" || words[i].rfind("--", 0) != 0) {
      arguments.scene = words[i] == "--scene" ? value() : words[i];
    }
  }
  if (words.empty() || arguments.scene.empty()) {
    std::cerr << "fake solver: usage\n";
    return 2;
  }
  return words[0] == "describe" ? describe(arguments.scene, regime) : run(arguments);
}
