// poreclog-solve: scenes in, numbers out.  The subcommands are in commands/.
#include <iostream>

#include "commands/describe.h"
#include "commands/measure.h"
#include "commands/program.h"
#include "commands/run.h"
#include "tiers/one_way.h"
#include "tiers/quasi_steady.h"

int main(int argc, char** argv) {
  using namespace colloid;
  const TierTable tiers{
      kSolveProgram,
      {{TierChoice::one_way, run_one_way}, {TierChoice::quasi_steady, run_quasi_steady}}};
  const Program program{
      kSolveProgram,
      "Simulates colloids that clog a pore throat",
      {{"run", "Run one realisation of a scene into a result file",
        [&] { return make_run(tiers); }},
       {"measure", "Measure flow, permeability, critical diameter and forces of a scene",
        make_measure},
       {"describe", "Print the keys of a scene with units, ranges and defaults",
        make_describe}}};
  const ProgramEnding ending = run_program(program, argc, argv);
  std::cerr << ending.complaint;
  return ending.exit_code;
}
