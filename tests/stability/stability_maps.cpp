// Prints four maps of outcomes as CSV: map, its parameter, step, outcome.
// scripts/stability_map.py draws them.
#include <cstdio>
#include <string>

#include "coupling_case.h"
#include "gap_case.h"
#include "impact_case.h"
#include "tiers/transient/runtime.h"

namespace {

using namespace colloid;

constexpr double kRelaxation = 1.03e-5;
constexpr double kSteps[] = {0.1, 1.0, 10.0, 100.0};
constexpr int kCount = 20;
const Vec3 kPlace{48.3e-6, 48.3e-6, 75e-6};

void print(const char* map, double parameter, double step, const char* outcome) {
  std::printf("%s,%g,%g,%s\n", map, parameter, step, outcome);
  std::fflush(stdout);
}

const char* name(const CouplingResult& result) {
  constexpr const char* kNames[] = {"bounded", "oscillating", "unstable"};
  return kNames[static_cast<int>(result.outcome)];
}

void over_gaps(const char* map, Weight weight) {
  for (const double gap : {0.3, 0.1, 0.01, 1e-3, 1e-4}) {
    for (const double step : {0.1, 0.3, 1.0, 10.0}) {
      print(map, gap, step, name(moved_at_wall(weight, gap, step * kRelaxation, kCount)));
    }
  }
}

void over_moduli() {
  constexpr const char* kNames[] = {"bounded", "warned", "unstable", "refused"};
  for (const double modulus : {7e5, 7e6, 7e7, 7e8, 7e9}) {
    for (const double step : {1e-8, 2.5e-8, 5e-8, 1e-7, 2.5e-7}) {
      print("modulus", modulus, step, kNames[static_cast<int>(impact(modulus, step))]);
    }
  }
}

void over_rigidity() {
  for (const double rigidity : {1.0, 10.0, 1e2, 1e3, 1e4, 1e6}) {
    for (const double step : kSteps) {
      print("rigidity", rigidity, step,
            name(coupled_motion(true, 1.05, step * kRelaxation, kCount, kPlace, 14, 1,
                                rigidity)));
    }
  }
}

void over_levels() {
  for (const int level : {0, 1, 2, 3}) {
    for (const double step : kSteps) {
      print("level", level, step,
            name(coupled_motion(true, 1.05, step * kRelaxation, kCount, kPlace, 10,
                                level)));
    }
  }
}

}  // namespace

// Which maps: their first letters, all without an argument.
int main(int argc, char** argv) {
  const Runtime runtime(argc, argv);
  const std::string maps = argc > 1 ? argv[1] : "mrlgs";
  std::puts("map,parameter,step,outcome");
  for (const char map : maps) {
    switch (map) {
      case 'm':
        over_moduli();
        break;
      case 'r':
        over_rigidity();
        break;
      case 'l':
        over_levels();
        break;
      case 'g':
        over_gaps("gap", Weight::towards_wall);
        break;
      case 's':
        over_gaps("sliding", Weight::along_wall);
        break;
      default:
        std::fputs("usage: stability_maps [letters of m, r, l, g, s]\n", stderr);
        return 2;
    }
  }
  return 0;
}
