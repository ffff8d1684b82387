// Prints the map of the two couplings as CSV: coupling, density ratio, step over
// relaxation time (of density ratio 1.05), outcome, last speed.  scripts/stability_map.py
// draws it.
#include <cstdio>

#include "coupling_case.h"
#include "tiers/transient/runtime.h"

int main(int argc, char** argv) {
  using namespace colloid;
  const Runtime runtime(argc, argv);
  constexpr double kRelaxation = 1.03e-5;
  constexpr const char* kNames[] = {"bounded", "oscillating", "unstable"};
  const Vec3 place{48.3e-6, 48.3e-6, 75e-6};
  std::puts("coupling,density_ratio,step_over_relaxation,outcome,last_speed_m_s");
  for (const bool implicit : {false, true}) {
    for (const double ratio : {0.5, 1.0, 1.05, 2.0, 8.0}) {
      for (const double step : {0.01, 0.03, 0.1, 0.2, 0.5, 1.0, 3.0, 10.0, 30.0, 100.0}) {
        const int steps = step < 0.1 ? 40 : 30;
        const CouplingResult found =
            coupled_motion(implicit, ratio, step * kRelaxation, steps, place, 20);
        std::printf("%s,%g,%g,%s,%.4e\n", implicit ? "implicit" : "explicit", ratio, step,
                    kNames[static_cast<int>(found.outcome)], found.last_speed);
        std::fflush(stdout);
      }
    }
  }
  return 0;
}
