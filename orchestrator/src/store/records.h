// What the database keeps of a realisation and of an attempt: plain values, SI units.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace colloid {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

struct RetainedRecord {
  std::int64_t order = 0;  ///< of retention, from 1
  std::int64_t colloid = 0;
  double time = kUndefined;                                             ///< [s]
  double contact_time = kUndefined;                                     ///< [s]
  double position[3] = {kUndefined, kUndefined, kUndefined};            ///< [m]
  double injection_position[3] = {kUndefined, kUndefined, kUndefined};  ///< [m]
  double injection_time = kUndefined;                                   ///< [s]
  std::string layer;
  std::string mechanism;
  double alpha_deg = kUndefined;
  double bond_load = kUndefined;  ///< [N]
};

struct ProgramRecord {
  std::string version;
  std::string commit;
  std::string compiler;
  std::string flags;
  std::string hdf5_version;
  std::string hostname;
  std::string cpu_model;
};

/// The content of a result file as far as the database keeps it.
struct ResultRecord {
  std::uint64_t seed = 0;
  std::string tier;
  std::string ending;
  double duration = kUndefined;  ///< simulated [s]
  double t1 = kUndefined;        ///< [s]
  double tc = kUndefined;        ///< [s]; NaN: censored
  double alpha_deg = kUndefined;
  double last_traversal = kUndefined;  ///< [s]
  std::int64_t injected = 0;
  std::int64_t retained_count = 0;
  std::int64_t traversed = 0;
  std::vector<double> times;               ///< [s]
  std::vector<double> critical_diameter;   ///< [m], at `times`
  std::vector<double> permeability_ratio;  ///< [-], at `times`
  std::vector<RetainedRecord> retained;
  ProgramRecord program;
  std::string scene;   ///< JSON; empty if the file does not say
  std::string digest;  ///< SHA-256 of all of the above that the seed determines
};

/// How an attempt stands or ended: the values of attempt.cause.
enum class Cause {
  running,
  finished,
  refused,  ///< the solver refused its input
  not_converged,
  internal_error,
  crashed,  ///< by a signal of its own making
  killed,   ///< by somebody else
  out_of_memory,
  time_limit,
  interrupted,     ///< asked to stop
  no_result,       ///< says it finished, and left no file
  torn_result,     ///< a file that is not whole
  foreign_result,  ///< a file of another realisation or scene
  not_started,     ///< the program could not be started
  lost  ///< ended without a trace: the machine stopped, or its keeper was killed
};

const char* name_of(Cause cause);
/// The cause of that name; lost for a name that is not known.
Cause cause_named(const std::string& name);

/// Does an attempt that ended so use up one of the attempts a realisation has?
bool counts_as_failure(Cause cause);
/// May the same attempt end differently the next time?
bool is_worth_retrying(Cause cause);

struct AttemptRecord {
  int number = 0;
  Cause cause = Cause::running;
  std::optional<int> exit_code;
  std::optional<int> signal;
  std::string started;  ///< ISO 8601
  std::string ended;
  double wall_seconds = kUndefined;
  double cpu_seconds = kUndefined;
  std::optional<std::int64_t> memory_kB;
  std::string node;
  std::string command;
  std::string message;
};

}  // namespace colloid
