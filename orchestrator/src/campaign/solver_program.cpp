#include "campaign/solver_program.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"
#include "base/memory_file.h"
#include "base/subprocess.h"

namespace colloid {

namespace {

using nlohmann::json;

bool is_program(const std::string& path) {
  return ::access(path.c_str(), X_OK) == 0 && !std::filesystem::is_directory(path);
}

std::string program_or_refuse(const std::string& path, const std::string& source) {
  require(is_program(path), source, path + " is not a program that can be run");
  return absolute(path);
}

}  // namespace

SolverProgram SolverProgram::find(const std::optional<std::string>& option) {
  if (option) {
    return SolverProgram(program_or_refuse(*option, "--solver"));
  }
  if (const char* named = std::getenv("PORECLOG_SOLVER")) {
    return SolverProgram(program_or_refuse(named, "PORECLOG_SOLVER"));
  }
  const std::filesystem::path here =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::array<std::filesystem::path, 2> places{here / "../solver/poreclog-solve",
                                                    here / "poreclog-solve"};
  const auto* const found =
      std::find_if(places.begin(), places.end(),
                   [](const auto& path) { return is_program(path.string()); });
  require(found != places.end(), "solver",
          fmt::format("there is no {}; name it with --solver or PORECLOG_SOLVER",
                      places[0].lexically_normal().string()));
  return SolverProgram(absolute(found->string()));
}

json SolverProgram::describe(const std::vector<std::string>& options,
                             const json& scene) const {
  const MemoryFile file(scene.dump(1) + "\n");
  std::vector<std::string> words{path_, "describe"};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(file.path());
  ProgramOutput output = run_program(words);
  // The file is our own affair: its name says nothing, and changes from run to run.
  for (std::size_t at = output.err.find(file.path()); at != std::string::npos;
       at = output.err.find(file.path(), at)) {
    output.err.replace(at, file.path().size(), "scene");
  }
  if (output.exit_code == 2) {
    std::string why = output.err.substr(0, output.err.find('\n'));
    const std::size_t name = why.find(": ");
    why = name == std::string::npos ? why : why.substr(name + 2);
    throw InputError("scene", why);
  }
  json parsed = json::parse(output.out, nullptr, false);
  require(output.exit_code == 0 && parsed.is_object(), path_,
          fmt::format("`describe` ended with {} and did not print a JSON object: {}",
                      output.exit_code, output.err.substr(0, output.err.find('\n'))));
  return parsed;
}

json SolverProgram::spell_out(const json& scene) const {
  return describe({"--scene"}, scene);
}

json SolverProgram::regime(const json& scene) const {
  return describe({"--json", "--regime"}, scene).value("regime", json::object());
}

std::vector<std::string> SolverProgram::run_command(
    const Plan& plan, const Item& item, const std::string& scene_file,
    const std::string& result_file) const {
  std::vector<std::string> words;
  std::string program = path_;
  if (plan.ensembles[item.ensemble].tier == "transient") {
    words = plan.executor == "slurm" && plan.slurm.launcher == "srun"
                ? std::vector<std::string>{"srun", "--mpi=pmix", "--kill-on-bad-exit=1",
                                           "-n", std::to_string(plan.ranks)}
                : std::vector<std::string>{"mpirun", "-n", std::to_string(plan.ranks)};
    program += "-transient";
  }
  words.insert(words.end(), {program, "run", scene_file, "-o", result_file, "--seed",
                             std::to_string(seed_of(plan, item))});
  return words;
}

}  // namespace colloid
