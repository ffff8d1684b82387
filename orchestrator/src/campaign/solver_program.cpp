#include "campaign/solver_program.h"

#include <algorithm>
#include <array>
#include <cmath>
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

// The program of the tier transient, beside the solver.
constexpr const char* kTransientSuffix = "-transient";

bool is_program(const std::string& path) {
  return ::access(path.c_str(), X_OK) == 0 && !std::filesystem::is_directory(path);
}

std::string program_or_refuse(const std::string& path, const std::string& source) {
  require(is_program(path), source, path + " is not a program that can be run");
  return absolute(path);
}

bool runs_transient(const Ensemble& ensemble) {
  return ensemble.runs_as == "transient";
}

/// What starts the ranks of a realisation.
std::vector<std::string> launcher(const Plan& plan) {
  const std::string ranks = std::to_string(plan.ranks);
  if (plan.executor == "slurm" && plan.slurm.launcher == "srun") {
    return {"srun", "--mpi=pmix", "--kill-on-bad-exit=1", "-n", ranks};
  }
  // Not bound to cores, or every realisation on a machine would be bound to the same
  // ones; and with the time to write a checkpoint after a SIGTERM, which is one second
  // otherwise.
  const double patience = std::ceil(plan.limits.seconds_to_stop);
  std::vector<std::string> words{"mpirun",
                                 "-n",
                                 ranks,
                                 "--bind-to",
                                 "none",
                                 "--mca",
                                 "odls_base_sigkill_timeout",
                                 fmt::format("{:.0f}", patience)};
  if (::geteuid() == 0) {
    words.emplace_back("--allow-run-as-root");
  }
  return words;
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

void SolverProgram::require_for(const Plan& plan) const {
  const bool needed =
      std::any_of(plan.ensembles.begin(), plan.ensembles.end(), runs_transient);
  require(!needed || is_program(path_ + kTransientSuffix), "/fidelity/tier",
          fmt::format("needs {}{}, which is not there: install OpenFOAM and LIGGGHTS "
                      "(scripts/install_packages.sh) and build it",
                      path_, kTransientSuffix));
}

std::vector<std::string> SolverProgram::run_command(
    const Plan& plan, const Item& item, const std::string& scene_file,
    const std::string& result_file) const {
  const bool transient = runs_transient(plan.ensembles[item.ensemble]);
  std::vector<std::string> words;
  if (transient && plan.ranks > 1) {
    words = launcher(plan);
  }
  const std::string program = path_ + (transient ? kTransientSuffix : "");
  words.insert(words.end(), {program, "run", scene_file, "-o", result_file, "--seed",
                             std::to_string(seed_of(plan, item))});
  return words;
}

}  // namespace colloid
