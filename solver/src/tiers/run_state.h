// Everything that changes while a realisation runs: what a checkpoint has to keep.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/realisation.h"
#include "particles/integrator.h"
#include "particles/suspension.h"

namespace colloid {

/// One piece of the deposit: colloids retained at the same instant, after which the flow
/// was solved once.
struct DepositBatch {
  std::vector<int> ids;
  std::vector<Sphere> spheres;
};

struct RunState {
  double time = 0.0;         ///< [s]
  double volume = 0.0;       ///< of suspension injected so far [m^3]
  int next_injection = 0;    ///< in the sequence
  std::vector<int> delayed;  ///< injections that wait for room, in order
  long times_delayed = 0;    ///< how many ever had to
  long next_output = 0;      ///< of the output times
  long thermal_steps = 0;    ///< steps with thermal forces so far: addresses their draws
  std::vector<RigidBody> bodies;
  std::vector<DepositBatch> deposit;
  long bonds_broken = 0;
  double next_step = 0.0;
  IntegratorCounts counts;
  Realisation realisation;
};

/// The state but for the realisation, as named arrays, and back.
void pack(const RunState& state, std::map<std::string, std::vector<double>>& reals,
          std::map<std::string, std::vector<std::int64_t>>& integers);
void unpack(const std::map<std::string, std::vector<double>>& reals,
            const std::map<std::string, std::vector<std::int64_t>>& integers,
            RunState& state);

}  // namespace colloid
