// The solver as the orchestrator knows it: a program with a command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/plan.h"

namespace colloid {

class SolverProgram {
 public:
  /// `path` of poreclog-solve; the program of the transient tier lies beside it.
  explicit SolverProgram(std::string path) : path_(std::move(path)) {}

  /// The one named by the option, else by PORECLOG_SOLVER, else the one built or
  /// installed beside this program.  InputError if there is none.
  static SolverProgram find(const std::optional<std::string>& option);

  const std::string& path() const { return path_; }

  /// `describe --scene`: the scene with every default spelled out.  InputError with the
  /// solver's own words if it is refused.
  nlohmann::json spell_out(const nlohmann::json& scene) const;

  /// `describe --regime --json`: the regime's numbers, the models and why.
  nlohmann::json regime(const nlohmann::json& scene) const;

  /// InputError if the plan has realisations of the tier transient and their program is
  /// not there.
  void require_for(const Plan& plan) const;

  /// The command line of one realisation.
  std::vector<std::string> run_command(const Plan& plan, const Item& item,
                                       const std::string& scene_file,
                                       const std::string& result_file) const;

 private:
  nlohmann::json describe(const std::vector<std::string>& options,
                          const nlohmann::json& scene) const;

  std::string path_;
};

}  // namespace colloid
