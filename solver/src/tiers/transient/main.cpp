// poreclog-solve-transient: the realisations that need inertia; alone or under mpirun.
#include "commands/program.h"
#include "commands/run.h"
#include "tiers/transient/library_errors.h"
#include "tiers/transient/runtime.h"
#include "tiers/transient/transient.h"

namespace colloid {

namespace {

std::optional<Realisation> run_with_our_errors(const Scene& scene,
                                               const RunOptions& options) {
  std::optional<Realisation> realisation;
  with_our_errors([&] { realisation = run_transient(scene, options); });
  return realisation;
}

}  // namespace

}  // namespace colloid

int main(int argc, char** argv) {
  using namespace colloid;
  Runtime runtime(argc, argv);
  const TierTable tiers{kTransientProgram,
                        {{TierChoice::transient, run_with_our_errors}},
                        runtime.rank() == 0,
                        [&](bool holds) { return runtime.on_all(holds); }};
  const Program program{kTransientProgram,
                        "Simulates colloids that clog a pore throat, with inertia",
                        {{"run", "Run one realisation of a scene into a result file",
                          [&] { return make_run(tiers); }}}};
  const ProgramEnding ending = run_program(program, argc, argv);
  return runtime.end(ending.exit_code, ending.complaint);
}
